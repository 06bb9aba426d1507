// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkDistributeParts
 * @brief   spreads the parts of an assembly over processes, each part whole in one of them
 *
 * Takes surfaces as the blocks of a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection, as
 * several processes (MPI ranks) have read them, and gives each process whole parts, about as much
 * work for all. The filters of this module that follow then work on the parts of all processes at
 * once, where otherwise the first would do it all. A single process passes its input as it is.
 *
 * A part is a block, or a partitioned (multi-piece) data set as a whole. The pieces of a part that
 * several processes have are put together, in their order and without ghost cells. It keeps the
 * arrays that all its pieces have, and says which others it leaves out; tags of cells (as
 * BoundaryTag) get one list of names (BoundaryTagNames) of all its pieces, and are renumbered where
 * these differ. The largest parts go first, each to the process with the least work so far; a
 * part's work is reckoned as its number of cells, and a little for itself.
 *
 * Output: the input's blocks, with their names and order, on every process; each holds only the
 * parts that are its own, as is usual with data on many processes. A process that has no blocks to
 * begin with, as one whose file another reads, gets their names from the others. It is an error
 * when processes disagree on how many there are. Data other than vtkPolyData are left out, with a
 * warning.
 *
 * No filter that follows waits for other processes. So a part that fails says so, with the name of
 * its block, and keeps none of the others from its solid, in whatever process. Only if the input of
 * a whole process fails, such as a file that it cannot read, no process has an output. An error in
 * each says whose input it was: parts may be in pieces, and would be incomplete.
 *
 * @sa vtkRobustTetrahedralize vtkProbeWindingNumber
 */
#ifndef vtkDistributeParts_h
#define vtkDistributeParts_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the controller

#include <memory>

namespace vtkInsideOut
{
class FailTogether;
}
class vtkMultiProcessController;

class VTKFILTERSINSIDEOUT_EXPORT vtkDistributeParts : public vtkPassInputTypeAlgorithm
{
public:
  static vtkDistributeParts* New();
  vtkTypeMacro(vtkDistributeParts, vtkPassInputTypeAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The processes to spread parts over, where each of them is asked for its own piece of the
   * output, as in pvserver and pvbatch, or by UpdatePiece(rank, ranks, 0). Default
   * vtkMultiProcessController's global one; none is this process alone.
   */
  void SetController(vtkMultiProcessController* controller);
  vtkMultiProcessController* GetController();
  ///@}

  int ModifyRequest(vtkInformation* request, int when) override;

protected:
  vtkDistributeParts();
  ~vtkDistributeParts() override;

  int FillInputPortInformation(int port, vtkInformation* info) override;
  int RequestInformation(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;
  int RequestData(vtkInformation* request, vtkInformationVector** inputVector,
    vtkInformationVector* outputVector) override;

  vtkSmartPointer<vtkMultiProcessController> Controller;

private:
  vtkDistributeParts(const vtkDistributeParts&) = delete;
  void operator=(const vtkDistributeParts&) = delete;

  const std::unique_ptr<vtkInsideOut::FailTogether> Failures;
};

#endif
