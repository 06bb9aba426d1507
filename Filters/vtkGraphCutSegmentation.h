// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkGraphCutSegmentation
 * @brief   labels the cells of a grid inside or outside by their winding numbers
 *
 * Takes a conforming grid (cells of one dimension, 2 or 3, that meet in whole faces) with a cell
 * array w of one component and finds the labelling that minimizes the energy of Jacobson, Kavan
 * and Sorkine-Hornung (2013), equations 8.8 to 8.10, as a minimum cut: each cell wants to be
 * inside as far as w is large, and neighbours with nearly equal w want the same label. The
 * result is a global minimum, of several the one with the fewest cells inside.
 *
 * Output: the input's cells with their data and the cell array Inside (unsigned char, 1 or 0),
 * or with ExtractInside, the default, only the cells inside. Field data:
 * Statistics_NAME of InsideCells, Energy and SecondsCut. On tetrahedra also: EnergyOfCut, before
 * the constraints; ForcedFacets (pieces of facets that a cell was labelled inside for), ForcedCells
 * (labelled inside for a constraint), ChangedCells (changed by all constraints), UnsatisfiedFacets
 * (pieces that seeds keep outside, or of dropped regions), NonManifoldPoints (that remain),
 * SeedConflicts; DroppedRegions, DroppedVolume, FilledCavities, FilledVolume, JoinedRegions (paths
 * made between two), EnergyBeforeTopology; SplitPoints (copies by NonManifold of the kind Split)
 * and NonManifoldEdges (0 except in overlaps).
 *
 * Seeds, ConstrainFacets, NonManifold, the choice of regions and Topology take grids of tetrahedra,
 * and Topology a convex one.
 *
 * @sa vtkGeneralizedWindingNumber
 *
 */
#ifndef vtkGraphCutSegmentation_h
#define vtkGraphCutSegmentation_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class vtkPointSet;

class VTKFILTERSINSIDEOUT_EXPORT vtkGraphCutSegmentation : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGraphCutSegmentation* New();
  vtkTypeMacro(vtkGraphCutSegmentation, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Weight of a smooth boundary against the winding number, without unit. 0 is thresholding: inside
   * where w > 1/2. Larger values cut off and fill up thin parts where w is unsure. Default 2, range
   * 0 to infinity.
   */
  vtkSetClampMacro(Gamma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * How large a step in w may be noise. Steps between two cells that are several times larger cost
   * nothing to cut along, smaller ones cost up to Gamma. Default 0.15, range 1e-6 to infinity.
   */
  vtkSetClampMacro(Sigma, double, 1e-6, VTK_DOUBLE_MAX);
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
   * How much a cell's own winding number counts: UNIFORM (0) as much as any other's, so that small
   * cells, of which there are many around details, keep what is thin; VOLUME_WEIGHTED (1) by
   * volume, so that slivers do not outvote large cells. Default UNIFORM.
   */
  vtkSetClampMacro(DataTerm, int, UNIFORM, VOLUME_WEIGHTED);
  vtkGetMacro(DataTerm, int);
  ///@}

  ///@{
  /**
   * Every piece of every facet has to be a face of a cell inside, also where it costs energy: for
   * thin sheets that are to be part of the solid. What is inside is then a local minimum. Takes
   * tetrahedra with the cell array FacetIds: faces where it is not negative are kept. Default off.
   */
  vtkSetMacro(ConstrainFacets, bool);
  vtkGetMacro(ConstrainFacets, bool);
  vtkBooleanMacro(ConstrainFacets, bool);
  ///@}

  /** What becomes of the solid's boundary where it is no 2-manifold. */
  enum NonManifoldType
  {
    NONMANIFOLD_KEEP = 0, ///< it stays so
    NONMANIFOLD_FILL = 1, ///< cells are added
    NONMANIFOLD_SPLIT = 2 ///< points are copied in their place
  };

  ///@{
  /**
   * What becomes of the solid's boundary where it is no 2-manifold, which has two faces at each
   * edge and one fan of faces at each point. NONMANIFOLD_KEEP (0): it stays so. NONMANIFOLD_FILL
   * (1): cells are added until it is one; what is inside is then a local minimum.
   * NONMANIFOLD_SPLIT (2): points are copied, so that parts of the solid that touch in points or
   * edges, and are not joined through faces around these, share none any more; places and cells
   * stay the same but for the points' ids, and vtkOriginalPointIds are those of the points that
   * were copied. Both take tetrahedra, and NONMANIFOLD_SPLIT takes ExtractInside. Default
   * NONMANIFOLD_KEEP.
   */
  vtkSetClampMacro(NonManifold, int, NONMANIFOLD_KEEP, NONMANIFOLD_SPLIT);
  vtkGetMacro(NonManifold, int);
  void SetNonManifoldToKeep() { this->SetNonManifold(NONMANIFOLD_KEEP); }
  void SetNonManifoldToFill() { this->SetNonManifold(NONMANIFOLD_FILL); }
  void SetNonManifoldToSplit() { this->SetNonManifold(NONMANIFOLD_SPLIT); }
  ///@}

  ///@{
  /**
   * How many regions of the solid stay at most, the largest by volume (in two dimensions by area);
   * regions are parts that faces connect. What is dropped counts in the statistics DroppedRegions
   * and DroppedVolume, and its facets are outliers; a seed that is to be inside goes with its
   * region, and counts in SeedConflicts, with a warning. Takes tetrahedra, as what follows does.
   * Default 0: any number. Range 0 to VTK_INT_MAX.
   */
  vtkSetClampMacro(LargestRegions, int, 0, VTK_INT_MAX);
  vtkGetMacro(LargestRegions, int);
  ///@}

  ///@{
  /**
   * Drop regions of a smaller volume, in two dimensions area, in the units of the input. Default 0:
   * none. Range 0 to infinity.
   */
  vtkSetClampMacro(MinimumRegionVolume, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MinimumRegionVolume, double);
  ///@}

  ///@{
  /**
   * Drop regions without a seed that is to be inside (second input). Default off.
   */
  vtkSetMacro(SeededRegions, bool);
  vtkGetMacro(SeededRegions, bool);
  vtkBooleanMacro(SeededRegions, bool);
  ///@}

  ///@{
  /**
   * Fill the solid's cavities, the parts of the outside that it encloses (in two dimensions its
   * holes), once regions are dropped; but not those with a seed that is to be outside. The
   * statistics FilledCavities and FilledVolume say how many. Default off.
   */
  vtkSetMacro(FillCavities, bool);
  vtkGetMacro(FillCavities, bool);
  vtkBooleanMacro(FillCavities, bool);
  ///@}

  /** What the solid's topology is to be, once regions are dropped and cavities filled. */
  enum TopologyType
  {
    TOPOLOGY_ANY = 0,             ///< as the segmentation has it
    TOPOLOGY_ONE_COMPONENT = 1,   ///< one region
    TOPOLOGY_SIMPLY_CONNECTED = 2 ///< one region without tunnels and cavities
  };

  ///@{
  /**
   * What the solid's topology is to be. TOPOLOGY_ANY (0): as the segmentation has it.
   * TOPOLOGY_ONE_COMPONENT (1): regions are joined, by the cells of shortest ways between them, or
   * dropped, whichever adds less energy, one after the other. TOPOLOGY_SIMPLY_CONNECTED (2): a ball
   * besides, in two dimensions a disc; tunnels and cavities are cut open by walls, or filled by
   * membranes, each tried in the way that adds less energy. Neither is a global minimum. Seeds,
   * ConstrainFacets and NonManifold of the kind Fill still hold; where they forbid what is asked
   * for a warning says so. The statistics have EnergyBeforeTopology, DroppedRegions and
   * JoinedRegions. Default TOPOLOGY_ANY.
   */
  vtkSetClampMacro(Topology, int, TOPOLOGY_ANY, TOPOLOGY_SIMPLY_CONNECTED);
  vtkGetMacro(Topology, int);
  void SetTopologyToAny() { this->SetTopology(TOPOLOGY_ANY); }
  void SetTopologyToOneComponent() { this->SetTopology(TOPOLOGY_ONE_COMPONENT); }
  void SetTopologyToSimplyConnected() { this->SetTopology(TOPOLOGY_SIMPLY_CONNECTED); }
  ///@}

  ///@{
  /**
   * Optional second input: points that have to be inside or outside, by their array Inside (1 or
   * 0). The cell that contains such a point, of several the one of the lowest id, gets that label.
   * Seeds win over ConstrainFacets and NonManifold; conflicts are warned about.
   */
  void SetSeedsData(vtkPointSet* seeds);
  void SetSeedsConnection(vtkAlgorithmOutput* output);
  ///@}

  ///@{
  /**
   * On: the output holds only the cells inside. Off: all cells of the hull, with the array Inside
   * to tell them apart. Default on.
   */
  vtkSetMacro(ExtractInside, bool);
  vtkGetMacro(ExtractInside, bool);
  vtkBooleanMacro(ExtractInside, bool);
  ///@}

protected:
  vtkGraphCutSegmentation();
  ~vtkGraphCutSegmentation() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
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

#endif
