// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkDistributeParts
 * @brief distributes the parts of an assembly over processes, each part whole in one of them
 *
 * Takes surfaces as the blocks of a vtkMultiBlockDataSet or vtkPartitionedDataSetCollection, as
 * several processes (MPI ranks) have read them, and gives each process whole parts, with balanced
 * work. Downstream filters of this module then work in all processes at once; otherwise the first
 * process would do all the work. A single process passes its input through.
 *
 * A part is a block, or a partitioned (multi-piece) data set as a whole. The MPI pieces of a part
 * are joined, in their order and without ghost cells. The part keeps the arrays that all its pieces
 * have, with warnings of the others; tags of cells (as BoundaryTag) get one list of names
 * (BoundaryTagNames) of all its pieces, and are renumbered where these differ. The largest parts go
 * first, each to the process with the least work so far; a part's work is its number of cells plus
 * a small constant.
 *
 * Output: the input's blocks, with their names and order, on every process; each holds only the
 * parts that are its own, as is usual with data on many processes. A process without blocks, whose
 * file another process reads, gets their names from the others. Different numbers of blocks are an
 * error. Data other than vtkPolyData are left out, with a warning.
 *
 * No downstream filter waits for other processes. So an error in a part names its block, and does
 * not affect the solids of other parts. If the whole input of a process fails, for example an
 * unreadable file, no process has an output, because parts in several pieces would be incomplete.
 * An error in each process names the failed one.
 *
 * @sa vtkRobustTetrahedralize vtkProbeWindingNumber
 */
#ifndef vtkDistributeParts_h
#define vtkDistributeParts_h

#include "vtkFiltersInsideOutModule.h" // for export macro
#include "vtkInsideOutVersions.h"      // for the ABI namespace
#include "vtkPassInputTypeAlgorithm.h"
#include "vtkSmartPointer.h" // for the controller

#include <memory>

namespace vtkInsideOut
{
class FailTogether;
}

VTK_ABI_NAMESPACE_BEGIN
class vtkMultiProcessController;

class VTKFILTERSINSIDEOUT_EXPORT vtkDistributeParts : public vtkPassInputTypeAlgorithm
{
public:
  static vtkDistributeParts* New();
  vtkTypeMacro(vtkDistributeParts, vtkPassInputTypeAlgorithm)
  void PrintSelf(ostream& os, vtkIndent indent) override;

  ///@{
  /**
   * The controller of the processes among which parts are distributed. Each process must request
   * its own piece of the output, as in pvserver and pvbatch, or by UpdatePiece(rank, ranks, 0).
   * Default vtkMultiProcessController's global one; null: this process alone.
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
VTK_ABI_NAMESPACE_END

#endif
