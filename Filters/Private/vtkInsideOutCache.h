// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   vtkInsideOutCache
 * @brief   keeps what a filter made of each of its inputs, for when only later stages change
 *
 * A filter that works on the blocks of a composite input one by one has a result for each. One is
 * forgotten when its input was deleted or modified, or is asked for with other parameters.
 */
#pragma once

#include <vtkDataObject.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

/** `Parameters` is whatever decides about the result beside the input; it is compared with ==. */
template <typename Parameters, typename Result>
class vtkInsideOutCache
{
public:
  /** The result for an input: the one that is remembered, or else what `make` makes. */
  template <typename Make>
  std::shared_ptr<Result> Get(vtkDataObject* input, const Parameters& parameters, const Make& make)
  {
    const auto isStale = [&](const Entry& entry)
    {
      return !entry.Input || entry.Input->GetMTime() != entry.InputTime ||
        entry.UsedParameters != parameters;
    };
    this->Entries.erase(
      std::remove_if(this->Entries.begin(), this->Entries.end(), isStale), this->Entries.end());
    const auto found = std::find_if(this->Entries.begin(), this->Entries.end(),
      [&](const Entry& entry) { return entry.Input == input; });
    if (found != this->Entries.end())
    {
      return found->Made;
    }
    std::shared_ptr<Result> made = make();
    this->Entries.push_back({ input, input->GetMTime(), parameters, made });
    return made;
  }

  void Forget() { this->Entries.clear(); }

private:
  struct Entry
  {
    vtkWeakPointer<vtkDataObject> Input;
    vtkMTimeType InputTime;
    Parameters UsedParameters;
    std::shared_ptr<Result> Made;
  };
  std::vector<Entry> Entries;
};
