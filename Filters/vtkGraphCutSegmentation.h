// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkGraphCutSegmentation
 * @brief   labels the cells of a grid inside or outside by their winding numbers
 *
 * Takes a conforming grid (cells of one dimension, 2 or 3, that meet in whole faces) with a cell
 * array w of one component. Finds the labelling of least energy (Jacobson, Kavan and
 * Sorkine-Hornung 2013, equations 8.8 to 8.10) by a minimum cut: cells with large w tend to be
 * inside, and neighbors with nearly equal w tend to have the same label. The result is a global
 * minimum; of several, that with the fewest cells inside.
 *
 * Output: the input's cells with their data, or with ExtractInside, the default, only the cells
 * inside.
 * - Inside (unsigned char, cells): 1 inside, 0 outside
 *
 * Statistics: InsideCells, Energy and SecondsCut. On tetrahedra also: EnergyOfCut, before the
 * constraints; ForcedFacets (pieces of facets that a cell was labelled inside for), ForcedCells
 * (labelled inside for a constraint), ChangedCells (changed by all constraints); UnsatisfiedFacets
 * (pieces that seeds keep outside, or of dropped regions), NonManifoldPoints (that remain),
 * SeedConflicts; DroppedRegions, DroppedVolume, FilledCavities, FilledVolume, JoinedRegions (paths
 * made between two), EnergyBeforeTopology; SplitPoints (copies by NonManifold of the kind Split)
 * and NonManifoldEdges (0 except in overlaps).
 *
 * Seeds, ConstrainFacets, NonManifold, the choice of regions and Topology take grids of tetrahedra,
 * and Topology a convex one.
 *
 * @sa vtkGeneralizedWindingNumber
 */
#ifndef vtkGraphCutSegmentation_h
#define vtkGraphCutSegmentation_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutRange.h"         // for setters with a range
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKFILTERSINSIDEOUT_EXPORT vtkGraphCutSegmentation : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGraphCutSegmentation* New();
  vtkTypeMacro(vtkGraphCutSegmentation, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Weight of a smooth boundary against w, the winding number, without unit. 0 takes every cell
   * with w above 1/2; larger values cut off and fill up thin parts where w is unsure. Default 2.
   * Range 0 to infinity.
   */
  vtkInsideOutSetRangeMacro(Gamma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * Step of w between neighboring cells that may be noise. Default 0.15. Range 1e-6 to infinity.
   * Cutting along steps several times larger costs nothing; along smaller ones it costs up to
   * Gamma.
   */
  vtkInsideOutSetRangeMacro(Sigma, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  /** How much a cell's own winding number counts against the others'. */
  enum DataTermType
  {
    UNIFORM = 0,        ///< every cell the same
    VOLUME_WEIGHTED = 1 ///< by the cell's volume over the mean volume
  };

  ///@{
  /**
   * Weight of a cell's own winding number. UNIFORM: every cell counts the same, which keeps what is
   * thin. VOLUME_WEIGHTED: cells count by volume, so that slivers do not outvote large cells.
   * Default UNIFORM.
   */
  vtkInsideOutSetRangeMacro(DataTerm, int, UNIFORM, VOLUME_WEIGHTED);
  vtkGetMacro(DataTerm, int);
  ///@}

  ///@{
  /**
   * Keep every piece of every facet as a face of a cell inside, thin sheets included. Default off.
   * The labels are then a local minimum. Requires tetrahedra with the cell array FacetIds: faces
   * where it is not negative are kept.
   */
  vtkSetMacro(ConstrainFacets, bool);
  vtkGetMacro(ConstrainFacets, bool);
  vtkBooleanMacro(ConstrainFacets, bool);
  ///@}

  /** Treatment of the solid's boundary where it is no 2-manifold. */
  enum NonManifoldType
  {
    NONMANIFOLD_KEEP = 0, ///< it stays so
    NONMANIFOLD_FILL = 1, ///< cells are added
    NONMANIFOLD_SPLIT = 2 ///< points are copied in their place
  };

  ///@{
  /**
   * Treatment of a boundary that is no 2-manifold. NONMANIFOLD_KEEP leaves it so, NONMANIFOLD_FILL
   * adds cells, NONMANIFOLD_SPLIT copies points, so that parts that touch share none. Default
   * NONMANIFOLD_KEEP. A 2-manifold has two faces at each edge and one fan of faces at each point.
   * After NONMANIFOLD_FILL what is inside is a local minimum. NONMANIFOLD_SPLIT copies points where
   * parts of the solid touch in points or edges and are not joined through faces around these;
   * cells stay, but for their points' ids, and vtkOriginalPointIds are those of the copied points.
   * Both require tetrahedra; NONMANIFOLD_SPLIT requires ExtractInside.
   */
  vtkInsideOutSetRangeMacro(NonManifold, int, NONMANIFOLD_KEEP, NONMANIFOLD_SPLIT);
  vtkGetMacro(NonManifold, int);
  void SetNonManifoldToKeep() { this->SetNonManifold(NONMANIFOLD_KEEP); }
  void SetNonManifoldToFill() { this->SetNonManifold(NONMANIFOLD_FILL); }
  void SetNonManifoldToSplit() { this->SetNonManifold(NONMANIFOLD_SPLIT); }
  ///@}

  ///@{
  /**
   * Number of regions that stay at most, the largest by volume, in a plane by area. A region is a
   * part that faces connect. Default 0: any number. Range 0 to infinity. The statistics
   * DroppedRegions and DroppedVolume count what is dropped; its facets are outliers. A seed in a
   * dropped region counts in SeedConflicts, with a warning. Requires tetrahedra, as the following
   * options do.
   */
  vtkInsideOutSetRangeMacro(LargestRegions, int, 0, VTK_INT_MAX);
  vtkGetMacro(LargestRegions, int);
  ///@}

  ///@{
  /** Volume below which regions are dropped, in a plane area, in units of the input. Default 0:
   * none. Range 0 to infinity. */
  vtkInsideOutSetRangeMacro(MinimumRegionVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumRegionVolume, double);
  ///@}

  ///@{
  /** Drop regions without a seed that is to be inside. Default off. */
  vtkSetMacro(SeededRegions, bool);
  vtkGetMacro(SeededRegions, bool);
  vtkBooleanMacro(SeededRegions, bool);
  ///@}

  ///@{
  /**
   * Fill the cavities that the solid encloses, in a plane its holes. Default off. Regions are
   * dropped first. Cavities with a seed that is to be outside stay. The statistics FilledCavities
   * and FilledVolume count the others.
   */
  vtkSetMacro(FillCavities, bool);
  vtkGetMacro(FillCavities, bool);
  vtkBooleanMacro(FillCavities, bool);
  ///@}

  /** Topology that the solid is to have, once regions are dropped and cavities filled. */
  enum TopologyType
  {
    TOPOLOGY_ANY = 0,             ///< as the segmentation has it
    TOPOLOGY_ONE_COMPONENT = 1,   ///< one region
    TOPOLOGY_SIMPLY_CONNECTED = 2 ///< one region without tunnels and cavities
  };

  ///@{
  /**
   * Topology that the solid is to have. TOPOLOGY_ANY: as the cut has it. TOPOLOGY_ONE_COMPONENT:
   * regions are joined or dropped, whichever adds less energy. TOPOLOGY_SIMPLY_CONNECTED: besides,
   * tunnels and cavities are cut open or filled. Default TOPOLOGY_ANY. Regions are joined by the
   * cells of shortest paths between them, one after the other. A simply connected solid is a ball,
   * in a plane a disc: tunnels are cut open by walls or filled by membranes, each in the way that
   * adds less energy. Neither result is a global minimum. Seeds, ConstrainFacets and
   * NONMANIFOLD_FILL still hold; a warning says where they forbid the topology. The statistics have
   * EnergyBeforeTopology, DroppedRegions and JoinedRegions.
   */
  vtkInsideOutSetRangeMacro(Topology, int, TOPOLOGY_ANY, TOPOLOGY_SIMPLY_CONNECTED);
  vtkGetMacro(Topology, int);
  void SetTopologyToAny() { this->SetTopology(TOPOLOGY_ANY); }
  void SetTopologyToOneComponent() { this->SetTopology(TOPOLOGY_ONE_COMPONENT); }
  void SetTopologyToSimplyConnected() { this->SetTopology(TOPOLOGY_SIMPLY_CONNECTED); }
  ///@}

  ///@{
  /**
   * Optional second input: points that have to be inside or outside, by their array Inside (1 or
   * 0). The cell that contains such a point, of several the one of the lowest id, gets that label.
   * Seeds win over ConstrainFacets and NonManifold; conflicts are warned about. The blocks of a
   * composite data set are one set of seeds.
   */
  void SetSeedsData(vtkDataObject* seeds);
  void SetSeedsConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /** Output only the cells inside. Off: all cells of the hull, told apart by the array Inside.
   * Default on. */
  vtkSetMacro(ExtractInside, bool);
  vtkGetMacro(ExtractInside, bool);
  vtkBooleanMacro(ExtractInside, bool);
  ///@}

protected:
  vtkGraphCutSegmentation();
  ~vtkGraphCutSegmentation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Gamma;
  double Sigma;
  int DataTerm;
  bool ConstrainFacets;
  int NonManifold = NONMANIFOLD_KEEP;
  int LargestRegions;
  double MinimumRegionVolume;
  bool SeededRegions;
  bool FillCavities;
  int Topology;
  bool ExtractInside = true;

private:
  vtkGraphCutSegmentation(const vtkGraphCutSegmentation&) = delete;
  void operator=(const vtkGraphCutSegmentation&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
