// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSurfaceReader
 * @brief   reads a surface from an OBJ, OFF, PLY or STL file in full precision
 *
 * Reads polygons from the four most common formats of surfaces, ascii or binary, compressed with
 * gzip or not. Coordinates keep all their digits (points are double), and the file is validated: an
 * id out of range, a count beyond the file's size, or a truncated file is an error. It names the
 * line or the element, and the output is empty.
 *
 * Output: polygons with the attributes that the file gives: Normals, TCoords and Colors, and any
 * other property of a PLY file under its own name. Points are in the file's order; if an OBJ file
 * gives a point several normals or texture coordinates, copies are appended.
 * - GroupIds, MaterialIds (int, cells): OBJ's objects and groups, or the solids of an STL file that
 *   has several; OBJ's materials
 * - GroupNames, MaterialNames (string, field data): the name for each such id. The name of an OBJ
 *   group is its object's if these are unique, else its own if these are unique, else OBJECT/GROUP
 *
 * @sa vtkRobustTetrahedralize
 */
#ifndef vtkSurfaceReader_h
#define vtkSurfaceReader_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkPolyDataAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class VTKFILTERSINSIDEOUT_EXPORT vtkSurfaceReader : public vtkPolyDataAlgorithm
{
public:
  static vtkSurfaceReader* New();
  vtkTypeMacro(vtkSurfaceReader, vtkPolyDataAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The file to read. The content decides its format, or else the name's ending, in upper or lower
   * case, with or without .gz. A warning says that name and content disagree.
   */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

protected:
  vtkSurfaceReader();
  ~vtkSurfaceReader() override;

  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkSurfaceReader(const vtkSurfaceReader&) = delete;
  void operator=(const vtkSurfaceReader&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
