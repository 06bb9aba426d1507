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
 * Statistics_NAME of InsideCells, Energy, SecondsCut, and on tetrahedra those that
 * vtkRobustTetrahedralize describes.
 *
 * Seeds, ConstrainFacets and NonManifold take grids of tetrahedra.
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
    NON_MANIFOLD_KEEP = 0, ///< it stays so
    NON_MANIFOLD_FILL = 1, ///< cells are added
    NON_MANIFOLD_SPLIT = 2 ///< points are copied in their place
  };

  ///@{
  /**
   * What becomes of the solid's boundary where it is no 2-manifold, which has two faces at each
   * edge and one fan of faces at each point. NON_MANIFOLD_KEEP (0): it stays so. NON_MANIFOLD_FILL
   * (1): cells are added until it is one; what is inside is then a local minimum.
   * NON_MANIFOLD_SPLIT (2): points are copied, so that parts of the solid that touch in points or
   * edges, and are not joined through faces around these, share none any more; places and cells
   * stay the same but for the points' ids, and vtkOriginalPointIds are those of the points that
   * were copied. Both take tetrahedra, and NON_MANIFOLD_SPLIT takes ExtractInside. Default
   * NON_MANIFOLD_KEEP.
   */
  vtkSetClampMacro(NonManifold, int, NON_MANIFOLD_KEEP, NON_MANIFOLD_SPLIT);
  vtkGetMacro(NonManifold, int);
  void SetNonManifoldToKeep() { this->SetNonManifold(NON_MANIFOLD_KEEP); }
  void SetNonManifoldToFill() { this->SetNonManifold(NON_MANIFOLD_FILL); }
  void SetNonManifoldToSplit() { this->SetNonManifold(NON_MANIFOLD_SPLIT); }
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
  int NonManifold = NON_MANIFOLD_KEEP;
  bool ExtractInside = true;

private:
  vtkGraphCutSegmentation(const vtkGraphCutSegmentation&) = delete;
  void operator=(const vtkGraphCutSegmentation&) = delete;
};

#endif
