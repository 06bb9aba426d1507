// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSurfaceWriter
 * @brief writes a surface as a PLY, OBJ, OFF or STL file, in the format's full precision
 *
 * Writes the polygons and strips of its input. The file name's ending selects the format: .ply,
 * .obj or .off (text with all digits) or .stl (binary; the format has only floats). The first three
 * read back with the same coordinates to the last bit.
 *
 * Normals, texture coordinates and colors (scalars of 3 or 4 unsigned char) are written to PLY and
 * OBJ, every other numeric array to PLY, none to OFF. In OBJ the groups come from the cell array
 * BoundaryTag, or else GroupIds, and the materials from MaterialIds, if BoundaryTagNames,
 * GroupNames or MaterialNames has their names. Lines and vertices are not written. A composite data
 * set is an error: a file holds one surface.
 *
 * A .stl file has neither coincident points nor triangles without area. Points that coincide after
 * rounding to floats are merged, and edges shorter than a millionth of the surface's size are
 * contracted. Points move to another float nearby, if that adds no intersections. A warning counts
 * the triangles that newly intersect, and the points that nearly coincide.
 *
 * The file is written atomically: an earlier one stays unchanged until the new one is on the disk,
 * also on errors. Symbolic links stay, and their targets are replaced; the permissions of an
 * earlier file are kept. Devices and pipes are written directly.
 *
 * Write() returns 1, or 0 after an error event that names the file and the reason, or the cell that
 * refers to a missing point. It returns 0 without an error event if it was aborted.
 *
 * @sa vtkSurfaceReader
 */
#ifndef vtkSurfaceWriter_h
#define vtkSurfaceWriter_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutVersions.h"      // for what a writer overrides, the ABI namespace
#include "vtkWriter.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKFILTERSINSIDEOUT_EXPORT vtkSurfaceWriter : public vtkWriter
{
public:
  static vtkSurfaceWriter* New();
  vtkTypeMacro(vtkSurfaceWriter, vtkWriter)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write, with the ending .ply, .obj, .off or .stl. An older file is replaced. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  ///@{
  /** The surface to write. */
  vtkPolyData* GetInput();
  vtkPolyData* GetInput(int port);
  ///@}

protected:
  vtkSurfaceWriter();
  ~vtkSurfaceWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkInsideOutWriteMacro();

  char* FileName = nullptr;

private:
  vtkSurfaceWriter(const vtkSurfaceWriter&) = delete;
  void operator=(const vtkSurfaceWriter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
