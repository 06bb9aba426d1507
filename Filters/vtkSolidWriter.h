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
 * from 0, and the names of these from its field array BoundaryTagNames. Each triangle has to be a
 * face of a cell; that of two cells is an interface. Without the second input the faces of one cell
 * are the boundary. Where there is no RegionId all cells are the region "solid", and without
 * BoundaryTag all triangles have the tag "surface". Other regions are called region_0, region_1 and
 * so on, and what is outside "outside"; tags without a name, tag_0, tag_1 and so on.
 *
 * - .msh has a physical group for each region and tag, with its name. Their numbers are RegionId
 *   and BoundaryTag plus 1; the outside has the number after the last.
 * - .inp has elements C3D4 or C3D10, and C3D6 for prisms, and for pyramids with a corner twice.
 *   Each region has an element set and a node set, each tag a node set and a surface by element
 * face; Eall and Nall are the sets of all.
 * - .mesh has the same numbers as references; names are in comments. For quadratic cells it has the
 *   sections TrianglesP2 and TetrahedraP2, which not every program reads.
 *
 * Point p is number p + 1 in each. Invalid characters in names become underscores, and the later of
 * equal names get the suffixes _2, _3 and so on. Coordinates read back to the last bit, except in
 * .inp: its 20 characters for a number are exact from 0.01 to 1e17, with a relative error below
 * 1e-12 elsewhere. Other arrays are not written.
 *
 * The first input may be a composite data set too, of which one block is the solid and at most one
 * other the boundary: what ParaView's Group Datasets makes of the two.
 *
 * The file is written atomically: an earlier one stays unchanged until the new one is on the disk,
 * also on errors. Symbolic links stay, and their targets are replaced; the permissions of an
 * earlier file are kept. Devices and pipes are written directly.
 *
 * No cell is changed. A warning counts the cells that a solver refuses: their Jacobian determinants
 * are below 1e-20 (CalculiX's limit), in doubles with the file's digits, at an integration point;
 * and those that it suffers from, with a dihedral angle below 1 degree. It names the option that
 * helps.
 *
 * Write() gives 1, or 0 after an error event that says which file cannot be written, and why, or
 * which cell, point, triangle or array is wrong. It gives 0 without one when it was aborted.
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
    MSHVERSION_4_1 = 0, ///< that of gmsh 4
    MSHVERSION_2_2 = 1  ///< the older one, for programs that know no other
  };

  ///@{
  /** Version of gmsh's format that a .msh file has: MSHVERSION_4_1, or MSHVERSION_2_2 for programs
   * that do not read the first. Default MSHVERSION_4_1. */
  vtkInsideOutSetRangeMacro(MshVersion, int, MSHVERSION_4_1, MSHVERSION_2_2);
  vtkGetMacro(MshVersion, int);
  ///@}

  ///@{
  /** Leave boundary and regions away, for programs that take one block of nodes and one of
   * elements. Default off. */
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
  /** How many cells of the last file a solver refuses, and suffers from. */
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
