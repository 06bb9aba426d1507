// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSolidReader
 * @brief   reads a solid from a MSH, INP or MESH file, with its regions and tags
 *
 * Reads what vtkSolidWriter writes, and what other programs write in these formats, by the file
 * name's ending: .msh (gmsh 4.1 and 2.x, ascii), .inp (Abaqus and CalculiX) or .mesh (Medit,
 * ascii). Coordinates keep all their digits (points are double). The file is validated: an element
 * that refers to a missing point, a count that the file does not hold, a coordinate that is not
 * finite, or a truncated file is an error. It names the line and the element, and the outputs are
 * empty.
 *
 * First output: the tetrahedra (vtkTetra, or vtkQuadraticTetra where all are quadratic), with the
 * cell array RegionId, and the names of regions in the field array RegionNames where the file has
 * any. From a file without tetrahedra it has the triangles, as a solid in a plane.
 *
 * Second output: the triangles in the file, of the boundary and of interfaces, with the cell array
 * BoundaryTag and the field array BoundaryTagNames. vtkSolidWriter takes both outputs and writes
 * the same groups again.
 *
 * - .msh: regions and tags are the physical groups, or the geometric entities if there are no
 *   groups. The first of several groups of an entity counts.
 * - .inp: regions are the ELSET of *ELEMENT; or the *ELSET lists, if each cell is in one of them,
 *   or if elements have no ELSET. Tags are the surfaces of element faces, and the sets of shells.
 *   The file must have one part. Included files are not read; a warning names them.
 * - .mesh: regions and tags are the references, their names the comments by vtkSolidWriter.
 *
 * RegionId and BoundaryTag are the file's numbers minus 1, and -1 for the group "outside" of
 * vtkSolidWriter. If the file has a number below 0 or above 65535, groups are numbered from 0
 * instead. Cells of no group get the number after the last. Points and cells are in the order of
 * their numbers in the file; points in no cell are kept. A warning counts other volumes and faces,
 * such as hexahedra; points, lines and everything else are skipped.
 *
 * @sa vtkSolidWriter
 */
#ifndef vtkSolidReader_h
#define vtkSolidReader_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkUnstructuredGridAlgorithm.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKFILTERSINSIDEOUT_EXPORT vtkSolidReader : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkSolidReader* New();
  vtkTypeMacro(vtkSolidReader, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to read, with the ending .msh, .inp or .mesh, in upper or lower case. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** The second output: the triangles of the boundary. */
  vtkPolyData* GetBoundary();

protected:
  vtkSolidReader();
  ~vtkSolidReader() override;

  int FillOutputPortInformation(int port, vtkInformation* info) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  char* FileName = nullptr;

private:
  vtkSolidReader(const vtkSolidReader&) = delete;
  void operator=(const vtkSolidReader&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
