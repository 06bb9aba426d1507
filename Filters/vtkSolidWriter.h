// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkSolidWriter
 * @brief   writes a solid for a solver, with its regions and the parts of its boundary by name
 *
 * Writes tetrahedra (vtkTetra, or vtkQuadraticTetra), and the prisms and pyramids (vtkWedge,
 * vtkPyramid) of vtkBoundaryLayers, which need the second input, by the file name's ending: .msh
 * (gmsh, ascii), .inp (CalculiX and Abaqus) or .mesh (Medit, ascii).
 *
 * Regions come from the solid's cell array RegionId: integers from 0, and -1 outside. The triangles
 * of the boundary come from the second input, their tags from its cell array BoundaryTag, integers
 * from 0, and the names of these from its field array BoundaryTagNames. Each triangle must be a
 * face of a cell; a face of two cells is an interface. Without the second input the faces of one
 * cell are the boundary. Without RegionId all cells are the region "solid", and without BoundaryTag
 * all triangles have the tag "surface". Otherwise regions are called region_0, region_1 and so on,
 * cells outside "outside", and tags without a name tag_0, tag_1 and so on.
 *
 * - .msh has a physical group with a name for each region and tag. Its number is RegionId or
 *   BoundaryTag plus 1; "outside" has the number after the last.
 * - .inp has elements C3D4 or C3D10, and C3D6 for prisms and for pyramids (with a corner repeated).
 *   Each region has an element set and a node set, each tag a node set and a surface by element
 *   face; Eall and Nall contain all elements and nodes.
 * - .mesh has the same numbers as references; names are in comments. Quadratic cells are in the
 *   sections TrianglesP2 and TetrahedraP2, which not every program reads.
 *
 * Point p is number p + 1 in each format. Invalid characters in names become underscores, and the
 * later of equal names get the suffixes _2, _3 and so on. Coordinates read back to the last bit,
 * except in .inp: its 20 characters for a number are exact from 0.01 to 1e17, with a relative error
 * below 1e-12 elsewhere. Other arrays are not written.
 *
 * The first input may also be a composite data set with one block for the solid and at most one for
 * the boundary, as ParaView's Group Datasets makes it.
 *
 * The file is written atomically: an earlier one stays unchanged until the new one is on the disk,
 * also on errors. Symbolic links stay, and their targets are replaced; the permissions of an
 * earlier file are kept. Devices and pipes are written directly.
 *
 * No cell is changed. A warning counts the cells that a solver refuses: with the file's digits, in
 * doubles, a Jacobian determinant at an integration point is below 1e-20 (CalculiX's limit). It
 * also counts poor cells, with a dihedral angle below 1 degree, and names the option that helps.
 *
 * Write() returns 1, or 0 after an error event that names the file and the reason, or the invalid
 * cell, point, triangle or array. It returns 0 without an error event if it was aborted.
 *
 * @sa vtkRobustTetrahedralize
 */
#ifndef vtkSolidWriter_h
#define vtkSolidWriter_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutRange.h"         // for setters with a range
#include "vtkInsideOutVersions.h"      // for what a writer overrides, the ABI namespace
#include "vtkWriter.h"

VTK_ABI_NAMESPACE_BEGIN
class vtkPolyData;

class VTKFILTERSINSIDEOUT_EXPORT vtkSolidWriter : public vtkWriter
{
public:
  static vtkSolidWriter* New();
  vtkTypeMacro(vtkSolidWriter, vtkWriter)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The file to write, with the ending .msh, .inp or .mesh. An older file is replaced. */
  vtkSetFilePathMacro(FileName);
  vtkGetFilePathMacro(FileName);
  ///@}

  /** The versions of gmsh's format. */
  enum MshVersionType
  {
    MSHVERSION_4_1 = 0, ///< the format of gmsh 4
    MSHVERSION_2_2 = 1  ///< the older format, for programs that read no other
  };

  ///@{
  /** Version of the .msh format: MSHVERSION_4_1, or MSHVERSION_2_2 for programs that do not read
   * the former. Default MSHVERSION_4_1. */
  vtkInsideOutSetRangeMacro(MshVersion, int, MSHVERSION_4_1, MSHVERSION_2_2);
  vtkGetMacro(MshVersion, int);
  ///@}

  ///@{
  /** Omit boundary and regions, for programs that read only one block of nodes and one of elements.
   * Default off. */
  vtkSetMacro(CellsOnly, bool);
  vtkGetMacro(CellsOnly, bool);
  vtkBooleanMacro(CellsOnly, bool);
  ///@}

  ///@{
  /**
   * The second input: triangles of the boundary, with the cell array BoundaryTag. Optional.
   */
  void SetBoundaryConnection(vtkAlgorithmOutput* boundary);
  void SetBoundaryData(vtkPolyData* boundary);
  ///@}

  ///@{
  /** Numbers of cells in the last file that a solver refuses, and of poor cells. */
  vtkGetMacro(RefusedCells, vtkIdType);
  vtkGetMacro(PoorCells, vtkIdType);
  ///@}

protected:
  vtkSolidWriter();
  ~vtkSolidWriter() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  vtkInsideOutWriteMacro();

  char* FileName = nullptr;
  int MshVersion = MSHVERSION_4_1;
  bool CellsOnly = false;
  vtkIdType RefusedCells = 0;
  vtkIdType PoorCells = 0;

private:
  vtkSolidWriter(const vtkSolidWriter&) = delete;
  void operator=(const vtkSolidWriter&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
