// SPDX-License-Identifier: GPL-3.0-or-later
#include "vtkDistributeParts.h"

#include "Data/Label.h"
#include "In/WholeInput.h"
#include "Ranks/Assembly.h"
#include "Ranks/FailTogether.h"
#include "Ranks/Gather.h"
#include "Run/RunFilter.h"

#include <vtkDataObjectTree.h>
#include <vtkInformation.h>
#include <vtkInformationVector.h>
#include <vtkMultiProcessController.h>
#include <vtkObjectFactory.h>
#include <vtkPolyData.h>

#include <algorithm>
#include <functional>
#include <numeric>
#include <queue>
#include <utility>

vtkStandardNewMacro(vtkDistributeParts);

vtkDistributeParts::vtkDistributeParts()
  : Controller(vtkMultiProcessController::GetGlobalController())
  , Failures(new vtkInsideOut::FailTogether)
{
}

vtkDistributeParts::~vtkDistributeParts() = default;

void vtkDistributeParts::PrintSelf(ostream& os, vtkIndent indent)
{
  this->Superclass::PrintSelf(os, indent);
  os << indent << "Controller: " << this->Controller << "\n";
}

void vtkDistributeParts::SetController(vtkMultiProcessController* controller)
{
  if (this->Controller != controller)
  {
    this->Controller = controller;
    this->Modified();
  }
}

vtkMultiProcessController* vtkDistributeParts::GetController()
{
  return this->Controller;
}

int vtkDistributeParts::ModifyRequest(vtkInformation* request, int when)
{
  return this->Failures->ModifyRequest(this, this->Controller, request, when);
}

int vtkDistributeParts::FillInputPortInformation(int vtkNotUsed(port), vtkInformation* info)
{
  info->Set(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkMultiBlockDataSet");
  info->Append(vtkAlgorithm::INPUT_REQUIRED_DATA_TYPE(), "vtkPartitionedDataSetCollection");
  return 1;
}

int vtkDistributeParts::RequestInformation(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** vtkNotUsed(inputVector), vtkInformationVector* outputVector)
{
  vtkInsideOut::SayWhetherPartsAreWhole(outputVector->GetInformationObject(0),
    this->Controller && this->Controller->GetNumberOfProcesses() > 1);
  return 1;
}

namespace
{
/** The cost of a part besides its cells, in cells: 3 ms, at 10 us per cell. */
constexpr double CellsOfAnyPart = 300;

/** The rank that gets each part: largest parts first, each to the rank with the least load so far.
 */
std::vector<int> ChooseOwners(const std::vector<vtkIdType>& cells, int ranks)
{
  std::vector<std::size_t> order(cells.size());
  std::iota(order.begin(), order.end(), 0);
  std::stable_sort(
    order.begin(), order.end(), [&](std::size_t a, std::size_t b) { return cells[a] > cells[b]; });
  using Load = std::pair<double, int>;
  std::priority_queue<Load, std::vector<Load>, std::greater<Load>> loads;
  for (int rank = 0; rank < ranks; ++rank)
  {
    loads.emplace(0, rank);
  }
  std::vector<int> owners(cells.size());
  for (const std::size_t part : order)
  {
    const Load least = loads.top();
    loads.pop();
    owners[part] = least.second;
    loads.emplace(least.first + cells[part] + CellsOfAnyPart, least.second);
  }
  return owners;
}
} // namespace

int vtkDistributeParts::RequestData(vtkInformation* vtkNotUsed(request),
  vtkInformationVector** inputVector, vtkInformationVector* outputVector)
{
  auto* input = vtkDataObjectTree::GetData(inputVector[0]);
  auto* output = vtkDataObjectTree::GetData(outputVector);
  vtkMultiProcessController* controller = this->Controller;
  if (!vtkInsideOut::AllRanksWork(controller, outputVector->GetInformationObject(0)))
  {
    output->ShallowCopy(input);
    return 1;
  }
  // All failures have to be the same on all ranks: none may return while another waits for it.
  vtkInsideOut::Assembly parts(input);
  const std::string disagreement = vtkInsideOut::Agree(parts, output, controller);
  if (!disagreement.empty())
  {
    output->Initialize();
    vtkErrorMacro(<< vtkInsideOut::Label(this) << disagreement);
    return 0;
  }
  if (parts.Others > 0)
  {
    vtkInsideOut::Warn(this,
      { std::to_string(parts.Others) +
        " blocks are left out, because they are not surfaces (vtkPolyData)" });
  }
  const std::vector<int> owners =
    ChooseOwners(vtkInsideOut::CountCells(parts, controller), controller->GetNumberOfProcesses());
  std::vector<std::string> warnings;
  vtkInsideOut::SetParts(vtkInsideOut::MoveParts(parts, owners, controller, warnings), output);
  vtkInsideOut::Warn(this, warnings);
  return 1;
}
