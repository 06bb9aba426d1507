// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkWindingNumberToImageStencil
 * @brief   the voxels inside a surface, however broken, as an image stencil
 *
 * Takes any triangle or polygon surface and makes a vtkImageStencilData of the voxels whose centers
 * are inside it, for vtkImageStencil, vtkImageAccumulate and the like. vtkPolyDataToImageStencil
 * does this for closed surfaces without self-intersections. Inside is where the surface's winding
 * number is above Threshold, as in the array Inside of vtkProbeWindingNumber. InformationInput
 * defines the image, or else OutputOrigin, OutputSpacing and OutputWholeExtent, with the defaults
 * of vtkImageStencilSource. The axes of a stencil are x, y and z: an image with a different
 * direction matrix is an error.
 *
 * Points with normals, without polygons and lines, are a cloud, as in vtkProbeWindingNumber; its
 * optional point array Area has the areas of its points.
 *
 * Bad input is an error that names the culprit, and the stencil is empty then.
 *
 * @sa vtkProbeWindingNumber vtkPolyDataToImageStencil vtkImageStencilSource
 */
#ifndef vtkWindingNumberToImageStencil_h
#define vtkWindingNumberToImageStencil_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkImageStencilSource.h"
#include "vtkInsideOutCounting.h" // for the options of counting
#include "vtkInsideOutVersions.h" // for the ABI namespace

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKFILTERSINSIDEOUT_EXPORT vtkWindingNumberToImageStencil : public vtkImageStencilSource
{
public:
  static vtkWindingNumberToImageStencil* New();
  vtkTypeMacro(vtkWindingNumberToImageStencil, vtkImageStencilSource)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The surface: polygons and strips. Lines and vertices beside them are ignored with a warning;
   * lines alone are an error. The blocks of a composite data set are one surface.
   */
  void SetInputData(vtkDataObject* surface);

  ///@{
  /** Winding number above which the center of a voxel is inside. Default 0.5. Range minus infinity
   * to infinity. */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro()
    vtkInsideOutCountDuplicatesMacro() vtkInsideOutNonParticipatingMacro()
    ///@}

    protected : vtkWindingNumberToImageStencil();
  ~vtkWindingNumberToImageStencil() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Threshold = 0.5;

private:
  vtkWindingNumberToImageStencil(const vtkWindingNumberToImageStencil&) = delete;
  void operator=(const vtkWindingNumberToImageStencil&) = delete;
};
VTK_ABI_NAMESPACE_END

#endif
