// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkWindingBoolean
 * @brief set operations of bodies whose surfaces may be broken
 *
 * Takes several polygonal surfaces, one for each body, and makes the surface of a set expression of
 * them, such as `A - (B | C) ^ D`. Each surface may cross itself, have overlapping, inverted or
 * duplicated parts, and touch, overlap and share faces with the others. It is oriented first; a
 * point is in a body if its winding number is above 1/2.
 *
 * One or several inputs are connected to port 0; each block of a composite data set is a body. The
 * names of bodies are those of blocks or of AddBodyName, otherwise letters from A on.
 *
 * There are two methods; the statistic Tetrahedra (0 or 1) says which was used. If all surfaces are
 * closed, they are cut exactly where they meet. Each piece is kept or dropped by the winding
 * numbers of all bodies on its two sides, without tetrahedra. If one is open, if bodies may be
 * nearer to each other than MergeTolerance, or with Tetrahedra on, all become one mesh of
 * tetrahedra. A graph cut labels each body in it (see vtkRobustTetrahedralize), and the cells where
 * the expression holds are the result.
 *
 * Output 0 is the surface: watertight, oriented outward, its triangles meet in shared points and
 * edges only.
 * - BodyId (int, cells and points): the body of a triangle or point, from 0; of several the lowest
 *   that faces outward there; -1 where a hole was closed, and for a new point
 * - BodyNames (string, field data): the names by BodyId
 * - vtkOriginalCellIds, vtkOriginalPointIds (vtkIdType, cells and points): the cell or point of
 *   that body's input; -1 where BodyId is
 * - Turned (unsigned char, cells): 1 where Orientation turned the input's cell over; a difference,
 *   which reverses facets, does not count
 *
 * Point and cell data of all inputs are passed on; an array that a body lacks is NaN there (0 in
 * integer arrays). Arrays of the same name but different types (strings, numbers) or numbers of
 * components are separated as BODY/ARRAY, with a warning. Arrays of an earlier operation are
 * replaced, so that chained operations gain no arrays.
 *
 * Tags stay with their triangles. BoundaryTag (int) comes from each body's own BoundaryTag, groups,
 * materials or solids, or else is the body's name; the field array BoundaryTagNames has the names.
 * GroupIds, MaterialIds, cell arrays of strings, and arrays of integers with names in a field array
 * (PartNames for Part or PartIds) stay, too: a body without the array gets its own name there. A
 * name that several bodies use is prefixed with the body's: cut/floor. Triangles that close a hole
 * are called hole.
 *
 * Output 1 has the tetrahedra of the result if they were made, else it is empty. It has the cell
 * arrays RegionId (int), the part connected through faces, and Inside, which is 1; and the point
 * arrays as above, NaN at Steiner points.
 *
 * A body without polygons is empty, with a warning; a body that the expression does not name gives
 * a warning, too. Errors leave the outputs empty: an invalid expression (the message gives the
 * column), and a point that is not finite or a cell with a point out of range (the message names
 * the body).
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
    UNION = 0,               ///< points in at least one body
    INTERSECTION = 1,        ///< points in all bodies
    DIFFERENCE = 2,          ///< points in the first and in no other
    SYMMETRIC_DIFFERENCE = 3 ///< points in an odd number of bodies
  };

  ///@{
  /**
   * Set expression of the bodies, such as A - (B | C). Operators are | or + (union), &
   * (intersection), - (difference) and ^ (symmetric difference). Default empty: Operation decides.
   * The precedence is that of Python and C++: + and -, then &, then ^, then |, each from left to
   * right; parentheses come first. A body is denoted by its name, in quotes if that has other
   * characters than letters, digits and underscores; by its number, #1 the first; or by a letter, A
   * the first, if no body has that name.
   */
  vtkSetStdStringFromCharMacro(Expression);
  vtkGetCharFromStdStringMacro(Expression);
  ///@}

  ///@{
  /**
   * Set operation of all bodies if Expression is empty. UNION: points in at least one of them;
   * INTERSECTION: in all; DIFFERENCE: in the first and no other; SYMMETRIC_DIFFERENCE: in an odd
   * number. Default UNION.
   */
  vtkInsideOutSetRangeMacro(Operation, int, UNION, SYMMETRIC_DIFFERENCE);
  vtkGetMacro(Operation, int);
  ///@}

  ///@{
  /**
   * The names of bodies in Expression and in the array BodyNames, one after the other. A body
   * without a name, or with an empty one, has that of its block, or a letter. GetBodyName counts
   * from 0, and returns nullptr if no name was added. Default none.
   */
  void AddBodyName(const char* name);
  void ClearBodyNames();
  int GetNumberOfBodyNames() const { return static_cast<int>(this->BodyNames.size()); }
  const char* GetBodyName(int body) const;
  ///@}

  ///@{
  /** Make tetrahedra even if all bodies are closed, and output those of the result. Default off:
   * only if a body is open. */
  vtkSetMacro(Tetrahedra, bool);
  vtkGetMacro(Tetrahedra, bool);
  vtkBooleanMacro(Tetrahedra, bool);
  ///@}

  ///@{
  /**
   * Join the pieces of an input triangle if all of them lie on the boundary. Default off: the
   * triangles of the boundary are faces of the cells. Pieces stay if another triangle needs the
   * points between them. The boundary stays watertight.
   */
  vtkSetMacro(MergeCoplanarPieces, bool);
  vtkGetMacro(MergeCoplanarPieces, bool);
  vtkBooleanMacro(MergeCoplanarPieces, bool);
  ///@}

  ///@{
  /**
   * How each body is counted: vtkInsideOutCounting.h describes these options. MergeTolerance also
   * merges points of different bodies and closes gaps between these, with a warning for each kind.
   * A facet is moved into the plane of a facet of an earlier body if all its corners are within
   * this distance. Gaps of uneven width, as between round faces, are closed by tetrahedra that
   * belong to the last adjacent body; see the statistics GapCells and GapVolume.
   */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro() vtkInsideOutTouchToleranceMacro()
    vtkInsideOutCountDuplicatesMacro()
    ///@}

    /** Output 1: the tetrahedra of the result, if they were made. */
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
