// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkVoxelFractions
 * @brief the fraction of each voxel within a solid of tetrahedra
 *
 * Takes a vtkImageData or vtkRectilinearGrid (port 0) and a vtkUnstructuredGrid of tetrahedra that
 * do not overlap (port 1), as vtkRobustTetrahedralize makes them. The output is the first input
 * with
 * - VolumeFraction (double, cells): the share of the cell's volume within the tetrahedra: 0
 *   outside, 1 inside, in between at the boundary
 *
 * If the grid covers the tetrahedra, the sum of fractions times cell volumes is their volume, up to
 * rounding. If the tetrahedra have a cell array Inside (one component), those where it is 0 do not
 * count; neither do other cells, such as triangles.
 *
 * An image whose axes are turned, or a grid whose coordinates do not ascend or are fewer than two,
 * is an error.
 *
 * @sa vtkRobustTetrahedralize vtkProbeWindingNumber
 */
#ifndef vtkVoxelFractions_h
#define vtkVoxelFractions_h

#include "vtkDataSetAlgorithm.h"
#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutVersions.h"      // for the ABI namespace

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKFILTERSINSIDEOUT_EXPORT vtkVoxelFractions : public vtkDataSetAlgorithm
{
public:
  static vtkVoxelFractions* New();
  vtkTypeMacro(vtkVoxelFractions, vtkDataSetAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /** The tetrahedra. The blocks of a composite data set are one solid, and must not overlap. */
  void SetSolidData(vtkDataObject* solid);
  void SetSolidConnection(vtkAlgorithmOutput* output);
  ///@}

protected:
  vtkVoxelFractions();
  ~vtkVoxelFractions() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

private:
  vtkVoxelFractions(const vtkVoxelFractions&) = delete;
  void operator=(const vtkVoxelFractions&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
