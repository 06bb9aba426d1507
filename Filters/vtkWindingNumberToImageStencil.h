// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkWindingNumberToImageStencil
 * @brief   the voxels inside a surface, however broken, as an image stencil
 *
 * Takes any triangle or polygon surface and gives a vtkImageStencilData of the voxels whose centres
 * are inside it, for vtkImageStencil, vtkImageAccumulate and their like: what
 * vtkPolyDataToImageStencil does for closed surfaces that do not cross themselves. Inside is where
 * the surface's winding number is above Threshold, as in vtkProbeWindingNumber, whose array Inside
 * on the image says the same. The image is told by InformationInput, or by OutputOrigin,
 * OutputSpacing and OutputWholeExtent, whose defaults are those of vtkImageStencilSource. A stencil
 * knows no other axes than x, y and z: an image with a direction of its own is an error.
 *
 * Points with normals, without polygons and lines, are a cloud, as in vtkProbeWindingNumber, whose
 * point array Area, if there is one, has the areas of its points.
 *
 * Bad input is an error that names the culprit, and the stencil is empty then.
 *
 * @sa vtkProbeWindingNumber vtkPolyDataToImageStencil vtkImageStencilSource
 */
#ifndef vtkWindingNumberToImageStencil_h
#define vtkWindingNumberToImageStencil_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkImageStencilSource.h"

#include <string>

class vtkPolyData;

class VTKFILTERSINSIDEOUT_EXPORT vtkWindingNumberToImageStencil : public vtkImageStencilSource
{
public:
  static vtkWindingNumberToImageStencil* New();
  vtkTypeMacro(vtkWindingNumberToImageStencil, vtkImageStencilSource)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /**
   * The surface: polygons and strips. Lines and vertices beside them are ignored with a warning;
   * lines alone are an error.
   */
  void SetInputData(vtkPolyData* surface);

  ///@{
  /**
   * A voxel is inside where w at its centre is above this, without unit. Default 0.5, range minus
   * infinity to infinity.
   */
  vtkSetMacro(Threshold, double);
  vtkGetMacro(Threshold, double);
  ///@}

  /** Which way the surface faces. */
  enum OrientationType
  {
    AUTOMATIC = 0, ///< what is inside out is turned over, with a warning
    AS_GIVEN = 1,  ///< nothing is
    REVERSE = 2,   ///< everything is
    OUTWARD = 3    ///< every part is made to face outward, within others too
  };

  ///@{
  /**
   * Which way facets are meant to face, as in vtkProbeWindingNumber. Default AUTOMATIC.
   */
  vtkSetClampMacro(Orientation, int, AUTOMATIC, OUTWARD);
  vtkGetMacro(Orientation, int);
  ///@}

  ///@{
  /**
   * Points at most this far apart become one, in units of the surface; of several the one with the
   * lowest id stays. Default 0: only points with equal coordinates are merged. Range 0 to infinity.
   */
  vtkSetClampMacro(MergeTolerance, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(MergeTolerance, double);
  ///@}

  ///@{
  /**
   * Count a polygon as often as it is given. Default off: triangles with the same three points
   * count once per orientation, and opposite ones cancel.
   */
  vtkSetMacro(CountDuplicates, bool);
  vtkGetMacro(CountDuplicates, bool);
  vtkBooleanMacro(CountDuplicates, bool);
  ///@}

  ///@{
  /**
   * Name of a cell array of the surface, of one number per cell: where it is not 0 the cell does
   * not count. Such a cell cancels no other. Default empty: every cell counts.
   */
  vtkSetStdStringFromCharMacro(NonParticipatingArrayName);
  vtkGetCharFromStdStringMacro(NonParticipatingArrayName);
  ///@}

protected:
  vtkWindingNumberToImageStencil();
  ~vtkWindingNumberToImageStencil() override = default;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Threshold = 0.5;
  int Orientation;
  double MergeTolerance;
  bool CountDuplicates;
  std::string NonParticipatingArrayName;

private:
  vtkWindingNumberToImageStencil(const vtkWindingNumberToImageStencil&) = delete;
  void operator=(const vtkWindingNumberToImageStencil&) = delete;
};

#endif
