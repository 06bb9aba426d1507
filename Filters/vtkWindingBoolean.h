// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkWindingBoolean
 * @brief set operations of bodies whose surfaces may be broken
 *
 * Takes several polygonal surfaces, one for each body, and makes the surface of a set expression of
 * them, such as `A - (B | C) ^ D`. Each surface may cross itself, have parts that overlap, face the
 * wrong way or are duplicated, and may touch, overlap and share faces with the others. It is
 * oriented first; a point is in a body if its winding number is above 1/2.
 *
 * Inputs are connected to port 0, one or several; of a composite data set each block is a body. The
 * names of bodies are those of blocks or of AddBodyName, otherwise letters from A on.
 *
 * There are two methods; the statistic Tetrahedra tells which was used (0 or 1). If all surfaces
 * are closed, all are cut exactly where they meet, and each piece is kept or dropped by the winding
 * numbers of all bodies on its two sides: no tetrahedra are made. If one is open, if bodies may be
 * nearer to each other than MergeTolerance, or with Tetrahedra on, all become one mesh of
 * tetrahedra. Each body has a cut of its own in it (vtkRobustTetrahedralize says how), and the
 * cells where the expression holds are the result.
 *
 * Output 0 is the surface: watertight, oriented outward, its triangles meet in shared points and
 * edges only.
 * - BodyId (int, cells and points): the body that a triangle is a piece of, from 0; of several the
 *   lowest that faces outward there; -1 where a hole was closed, and for a new point
 * - BodyNames (string, field data): the names by BodyId
 * - vtkOriginalCellIds, vtkOriginalPointIds (vtkIdType, cells and points): the cell or point of
 *   that body's input; -1 likewise
 * - Turned (unsigned char, cells): 1 where the orientation turned the input's cell over; what a
 *   difference cuts out is not counted
 *
 * Point and cell data of all inputs are passed on: an array that a body has not is NaN there, 0 in
 * arrays of integers. Arrays of one name that are of strings and numbers, or have different numbers
 * of components, stay apart as BODY/ARRAY, with a warning. Arrays of an earlier result that this
 * one has of its own are replaced, so that chained operations gain no arrays.
 *
 * Tags stay with their triangles: BoundaryTag (int) is what each body says of its cells, by its own
 * BoundaryTag, groups, materials or solids, or else the body's name; BoundaryTagNames in the field
 * data names each. So do GroupIds, MaterialIds, cell arrays of strings, and those of integers that
 * a field array names (PartNames for Part or PartIds): a body without the array is called by its
 * name there. A name that several bodies use has the body's before it: cut/floor. Triangles that
 * close a hole are called hole.
 *
 * Output 1 is the tetrahedra of the result where they were made, else it is empty: with the cell
 * array RegionId (int), which numbers the parts that faces connect, the point arrays as above, NaN
 * at Steiner points, and Inside, which is 1.
 *
 * A body without polygons is empty, with a warning, and so is one that the expression does not
 * name. An error in the expression names its column; a point that is not finite or a cell with a
 * point out of range is an error that names the body. The outputs are then empty.
 *
 * @sa vtkRobustTetrahedralize vtkResolveSelfIntersections
 */
#ifndef vtkWindingBoolean_h
#define vtkWindingBoolean_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutCounting.h"      // for the options of counting
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkPolyDataAlgorithm.h"

#include <string> // for the expression
#include <vector> // for the names

VTK_ABI_NAMESPACE_BEGIN
class vtkUnstructuredGrid;

class VTKFILTERSINSIDEOUT_EXPORT vtkWindingBoolean : public vtkPolyDataAlgorithm
{
public:
  static vtkWindingBoolean* New();
  vtkTypeMacro(vtkWindingBoolean, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  enum OperationType
  {
    UNION = 0,               ///< what is in one body at least
    INTERSECTION = 1,        ///< what is in all of them
    DIFFERENCE = 2,          ///< what is in the first and in no other
    SYMMETRIC_DIFFERENCE = 3 ///< what is in an odd number of them
  };

  ///@{
  /**
   * Set expression of the bodies, such as A - (B | C). Operators are | or + (union), &
   * (intersection), - (difference) and ^ (symmetric difference). Default empty: Operation says it.
   * The precedence is that of Python and C++: + and - first, then &, then ^, then |; among equals
   * the left first. Parentheses go before all. A body is called by its name, in quotes where that
   * is more than letters, digits and underscores; by its number, #1 the first; or by a letter, A
   * the first, where none has that name.
   */
  vtkSetStdStringFromCharMacro(Expression);
  vtkGetCharFromStdStringMacro(Expression);
  ///@}

  ///@{
  /**
   * Set operation of all bodies where Expression is empty. UNION: what is in at least one of them;
   * INTERSECTION: in all; DIFFERENCE: in the first and no other; SYMMETRIC_DIFFERENCE: in an odd
   * number. Default UNION.
   */
  vtkInsideOutSetRangeMacro(Operation, int, UNION, SYMMETRIC_DIFFERENCE);
  vtkGetMacro(Operation, int);
  ///@}

  ///@{
  /**
   * The names of bodies in Expression and in BodyNames, one after the other. A body without a
   * name, or with an empty one, has that of its block, or a letter. GetBodyName counts from 0, and
   * gives nullptr where no name was added. Default none.
   */
  void AddBodyName(const char* name);
  void ClearBodyNames();
  int GetNumberOfBodyNames() const { return static_cast<int>(this->BodyNames.size()); }
  const char* GetBodyName(int body) const;
  ///@}

  ///@{
  /** Make tetrahedra even where all bodies are closed, and give those of the result as output 1.
   * Default off: only where a body is open. */
  vtkSetMacro(Tetrahedra, bool);
  vtkGetMacro(Tetrahedra, bool);
  vtkBooleanMacro(Tetrahedra, bool);
  ///@}

  ///@{
  /**
   * Join the pieces of an input triangle on the boundary where all of it lies there. Default off:
   * the triangles of the boundary are faces of the cells, where there are cells. Pieces stay where
   * another triangle needs the points between. The boundary stays watertight.
   */
  vtkSetMacro(MergeCoplanarPieces, bool);
  vtkGetMacro(MergeCoplanarPieces, bool);
  vtkBooleanMacro(MergeCoplanarPieces, bool);
  ///@}

  ///@{
  /**
   * How each body is counted: vtkInsideOutCounting.h describes these options. MergeTolerance also
   * merges points of different bodies and closes gaps between these, with a warning for each kind.
   * A facet all of whose corners are that near to the plane of a facet of an earlier body is moved
   * into it. Gaps of uneven width, as
   * between round faces, are closed by tetrahedra that belong to the last body beside them; see the
   * statistics GapCells and GapVolume.
   */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro() vtkInsideOutTouchToleranceMacro()
    vtkInsideOutCountDuplicatesMacro()
    ///@}

    /** The tetrahedra of the result, where they were made: output 1. */
    vtkUnstructuredGrid* GetTetrahedraOutput();

protected:
  vtkWindingBoolean();
  ~vtkWindingBoolean() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  std::string Expression;
  int Operation;
  std::vector<std::string> BodyNames;
  bool Tetrahedra = false;
  bool MergeCoplanarPieces = false;

private:
  vtkWindingBoolean(const vtkWindingBoolean&) = delete;
  void operator=(const vtkWindingBoolean&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
