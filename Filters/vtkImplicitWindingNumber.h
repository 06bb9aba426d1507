// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkImplicitWindingNumber
 * @brief   a surface, however broken, as an implicit function: 1/2 less its winding number
 *
 * The function is 1/2 - w, with w the generalized winding number of Jacobson, Kavan and
 * Sorkine-Hornung (2013) of the surface: negative inside, positive outside, and with a zero that
 * closes the surface's holes. It drives vtkClipDataSet, vtkCutter, vtkSampleFunction,
 * vtkContourFilter and vtkExtractGeometry. The surface is neither resolved nor meshed.
 *
 * The function jumps across the surface: it is no distance. On a closed surface it is constant on
 * each side (1/2 and -1/2 where w is 0 and 1). So a contour of its samples is only as fine as
 * these. EvaluateGradient gives its gradient away from the surface, analytically: zero everywhere
 * on a closed surface, and a Biot-Savart integral over the open edges of an open one.
 *
 * With SignedDistance the function is the distance to the nearest polygon, negative inside. Its
 * sign follows from w, so it is right also where the surface is open or not manifold. It jumps in
 * holes, where w passes 1/2 but no polygon is near.
 *
 * Evaluation is thread-safe, as long as neither the properties nor the surface change. Without a
 * surface, or if it is invalid (an error that names the culprit), the function is 1/2: everything
 * is outside. It is NaN if x is not finite.
 *
 * For lines without polygons, which have to lie in one plane, w is the winding number of the curve
 * there: 1 inside a curve that runs counter-clockwise, seen from the side where the largest
 * component of the plane's normal is positive. A query point off the plane has the w of its
 * projection onto the plane.
 *
 * Points with normals, without polygons and lines, are a point cloud, such as a scan (vertices are
 * ignored). Its w is that of Barill, Dickson, Schmidt, Levin and Jacobson (2018): with areas a,
 * unit normals n and positions p of the points
 *
 *     w(q) = sum of a n . (p - q) / (4 pi |p - q|^3).
 *
 * Areas are those of AreaArrayName, or those of each point's Voronoi cell among its 20 nearest
 * neighbors in its tangent plane. A term is unbounded near its point, so it is damped to 0 within
 * the radius of a disk of the point's area. So w changes smoothly from 1 to 0 across a layer as
 * thick as the spacing of points, and has no further meaning in this layer. Sums are by a tree of
 * expansions that err by 1e-2 of the sum of a / (4 pi |p - q|^2) at most, in practice by some 1e-4;
 * the gradient is that of the same terms and errs by some hundredths. Orientation REVERSE reverses
 * all normals; its other values reverse none. All other options apply to polygons only. The
 * function is smooth, so a contour of its samples approximates the scanned surface.
 *
 * @sa vtkProbeWindingNumber vtkImplicitPolyDataDistance
 */
#ifndef vtkImplicitWindingNumber_h
#define vtkImplicitWindingNumber_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkImplicitFunction.h"
#include "vtkInsideOutCounting.h" // for the options of counting
#include "vtkInsideOutVersions.h" // for the ABI namespace

#include <string>

VTK_ABI_NAMESPACE_BEGIN
class vtkDataObject;

class VTKFILTERSINSIDEOUT_EXPORT vtkImplicitWindingNumber : public vtkImplicitFunction
{
public:
  static vtkImplicitWindingNumber* New();
  vtkTypeMacro(vtkImplicitWindingNumber, vtkImplicitFunction)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  /** The latest change of the function and of its surface. */
  vtkMTimeType GetMTime() override;

  ///@{
  /**
   * The surface: polygons and strips (lines and vertices beside them are ignored with a warning),
   * or lines alone, or points with normals alone. The blocks of a composite data set are one
   * surface.
   */
  virtual void SetInput(vtkDataObject* surface);
  vtkGetObjectMacro(Input, vtkDataObject);
  ///@}

  ///@{
  /** 1/2 - w, or the signed distance, at one place or at each tuple of three components. */
  using vtkImplicitFunction::EvaluateFunction;
  double EvaluateFunction(double x[3]) override;
  void EvaluateFunction(vtkDataArray* input, vtkDataArray* output) override;
  ///@}

  /**
   * The gradient of 1/2 - w, away from the surface; zero where the surface is closed. The gradient
   * of the signed distance has length 1 and points away from the nearest point of the surface
   * outside, and toward it inside; on the surface itself it is zero.
   */
  void EvaluateGradient(double x[3], double g[3]) override;

  ///@{
  /** Evaluate the distance to the nearest polygon, in units of the surface, negative where w is
   * above 1/2, instead of 1/2 - w. An error for lines. Default off. */
  vtkSetMacro(SignedDistance, bool);
  vtkGetMacro(SignedDistance, bool);
  vtkBooleanMacro(SignedDistance, bool);
  ///@}

  ///@{
  /** How the input is counted: vtkInsideOutCounting.h describes these options. */
  vtkInsideOutOrientationMacro() vtkInsideOutMergeToleranceMacro()
    vtkInsideOutCountDuplicatesMacro() vtkInsideOutNonParticipatingMacro()
    ///@}

    ///@{
    /** Point array of the areas that a cloud's points stand for, in squared units of the surface.
     * Default "Area"; without it the areas are estimated. Areas are at least 0. */
    vtkSetStdStringFromCharMacro(AreaArrayName);
  vtkGetCharFromStdStringMacro(AreaArrayName);
  ///@}

protected:
  vtkImplicitWindingNumber();
  ~vtkImplicitWindingNumber() override;

  vtkDataObject* Input = nullptr;
  bool SignedDistance = false;
  std::string AreaArrayName;

private:
  vtkImplicitWindingNumber(const vtkImplicitWindingNumber&) = delete;
  void operator=(const vtkImplicitWindingNumber&) = delete;

  class Internal;
  Internal* Built;

  void Build();
  const Internal& UpToDate();
};
VTK_ABI_NAMESPACE_END

#endif
