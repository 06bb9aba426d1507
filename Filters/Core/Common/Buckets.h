// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <algorithm>
#include <cstddef>
#include <utility>
#include <vector>

namespace insideout
{
/** Values sorted by buckets, in contiguous memory. */
template <typename Value>
class Buckets
{
public:
  /** No buckets. */
  Buckets()
    : Begin(2, 0)
  {
  }

  /**
   * @param[in] count of buckets
   * @param[in] forEach calls visit(bucket, value) for each value. It is called twice with the same
   * result; within a bucket the values keep their order
   */
  template <typename ForEach>
  Buckets(std::size_t count, const ForEach& forEach)
    : Begin(count + 2, 0)
  {
    // Counted one bucket ahead, so that filling moves each Begin to its final position.
    forEach([this](std::size_t bucket, const Value&) { ++this->Begin[bucket + 2]; });
    for (std::size_t bucket = 2; bucket < this->Begin.size(); ++bucket)
    {
      this->Begin[bucket] += this->Begin[bucket - 1];
    }
    this->Values.resize(this->Begin.back());
    forEach([this](std::size_t bucket, const Value& value)
      { this->Values[this->Begin[bucket + 1]++] = value; });
  }

  struct Range
  {
    const Value* First;
    const Value* Last;
    const Value* begin() const { return this->First; }
    const Value* end() const { return this->Last; }
    std::size_t Size() const { return static_cast<std::size_t>(this->Last - this->First); }
  };

  /** The values of a bucket. */
  Range operator[](std::size_t bucket) const
  {
    const Value* const values = this->Values.data();
    return { values + this->Begin[bucket], values + this->Begin[bucket + 1] };
  }

  /** The number of buckets. */
  std::size_t Size() const { return this->Begin.size() - 2; }

  /** Sort within a bucket. */
  template <typename Less>
  void Sort(std::size_t bucket, const Less& less)
  {
    Value* const values = this->Values.data();
    std::sort(values + this->Begin[bucket], values + this->Begin[bucket + 1], less);
  }

  /** Release all values, bucket by bucket; the buckets are unusable afterwards. */
  std::vector<Value> TakeAll() && { return std::move(this->Values); }

private:
  std::vector<std::size_t> Begin;
  std::vector<Value> Values;
};
} // namespace insideout
