// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   Cache
 * @brief caches a filter's intermediate result for each of its inputs, for changes of later stages
 * only
 *
 * A filter that works on the blocks of a composite input one by one has a result for each. A result
 * is dropped when its input was deleted or modified, or is requested with other parameters.
 */
#pragma once

#include <vtkDataObject.h>
#include <vtkWeakPointer.h>

#include <algorithm>
#include <memory>
#include <utility>
#include <vector>

namespace vtkInsideOut
{
/** `Parameters` is the rest of the cache key besides the input; compared with ==. */
template <typename Parameters, typename Result>
class Cache
{
public:
  /** The result for an input: the cached one, or else that of `make`. */
  template <typename Make>
  std::shared_ptr<Result> Get(vtkDataObject* input, const Parameters& parameters, const Make& make)
  {
    std::shared_ptr<Result> made = this->Find(input, parameters);
    if (!made)
    {
      made = make();
      this->Remember(input, parameters, made);
    }
    return made;
  }

  /** The cached result, or null. */
  std::shared_ptr<Result> Find(vtkDataObject* input, const Parameters& parameters)
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
    return found != this->Entries.end() ? found->Made : nullptr;
  }

  void Remember(vtkDataObject* input, const Parameters& parameters, std::shared_ptr<Result> made)
  {
    this->Entries.push_back({ input, input->GetMTime(), parameters, std::move(made) });
  }

  /** The entry of one input. */
  void Forget(vtkDataObject* input)
  {
    this->Entries.erase(std::remove_if(this->Entries.begin(), this->Entries.end(),
                          [&](const Entry& entry) { return entry.Input == input; }),
      this->Entries.end());
  }

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
} // namespace vtkInsideOut
