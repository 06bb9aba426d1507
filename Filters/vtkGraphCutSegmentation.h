// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkGraphCutSegmentation
 * @brief   labels the cells of a grid inside or outside by their winding numbers
 *
 * Takes a conforming grid (cells of one dimension, 2 or 3, that meet in whole faces) with a cell
 * array w of one component and finds the labelling that minimizes the energy of Jacobson, Kavan
 * and Sorkine-Hornung (2013), equations 8.8 to 8.10, as a minimum cut: each cell wants to be
 * inside as far as w is large, and neighbours with nearly equal w want the same label. The
 * result is a global minimum, of several the one with the fewest cells inside.
 *
 * Output: the input's cells with their data and the cell array Inside (unsigned char, 1 or 0),
 * or with ExtractInside, the default, only the cells inside. Field data: Statistics_InsideCells,
 * Statistics_Energy, Statistics_SecondsCut.
 *
 * @sa vtkGeneralizedWindingNumber
 *
 */
#ifndef vtkGraphCutSegmentation_h
#define vtkGraphCutSegmentation_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkUnstructuredGridAlgorithm.h"

class VTKFILTERSINSIDEOUT_EXPORT vtkGraphCutSegmentation : public vtkUnstructuredGridAlgorithm
{
public:
  static vtkGraphCutSegmentation* New();
  vtkTypeMacro(vtkGraphCutSegmentation, vtkUnstructuredGridAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * Weight of a smooth boundary against the winding number, without unit. 0 is thresholding: inside
   * where w > 1/2. Larger values cut off and fill up thin parts where w is unsure. Default 1, range
   * 0 to infinity.
   */
  vtkSetClampMacro(Gamma, double, 0.0, VTK_DOUBLE_MAX);
  vtkGetMacro(Gamma, double);
  ///@}

  ///@{
  /**
   * How large a step in w may be noise. Steps between two cells that are several times larger cost
   * nothing to cut along, smaller ones cost up to Gamma. Default 0.1, range 1e-6 to infinity.
   */
  vtkSetClampMacro(Sigma, double, 1e-6, VTK_DOUBLE_MAX);
  vtkGetMacro(Sigma, double);
  ///@}

  ///@{
  /**
   * On: the output holds only the cells inside. Off: all cells of the hull, with the array Inside
   * to tell them apart. Default on.
   */
  vtkSetMacro(ExtractInside, bool);
  vtkGetMacro(ExtractInside, bool);
  vtkBooleanMacro(ExtractInside, bool);
  ///@}

protected:
  vtkGraphCutSegmentation();
  ~vtkGraphCutSegmentation() override = default;

  int RequestUpdateExtent(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  double Gamma = 1.0;
  double Sigma = 0.1;
  bool ExtractInside = true;

private:
  vtkGraphCutSegmentation(const vtkGraphCutSegmentation&) = delete;
  void operator=(const vtkGraphCutSegmentation&) = delete;
};

#endif
