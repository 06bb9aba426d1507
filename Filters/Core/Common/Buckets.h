// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "Common/ParallelLoop.h"
#include "Common/RawVector.h"

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
    this->AddUpSizes();
    forEach([this](std::size_t bucket, const Value& value)
      { this->Values[this->Begin[bucket + 1]++] = value; });
  }

  /**
   * The same on several threads. Values may be in any order within a bucket that several elements
   * visit: sort them.
   *
   * @param[in] elements number of elements
   * @param[in] cost estimated nanoseconds of one element
   * @param[in] forElement calls visit(bucket, value) for each value of an element. It is called
   * twice with the same result
   */
  template <typename ForElement>
  static Buckets Unordered(
    std::size_t count, std::size_t elements, double cost, const ForElement& forElement)
  {
    const double nanoseconds = static_cast<double>(elements) * cost;
    const int threads = TeamSize(nanoseconds);
    if (threads == 1)
    {
      return Buckets(count,
        [&](auto visit)
        {
          for (std::size_t i = 0; i < elements; ++i)
          {
            forElement(i, visit);
          }
        });
    }
    Buckets all;
    all.Begin.assign(count + 2, 0);
    if (threads <= MostRanges)
    {
      const auto forAll = [&](const auto& visit)
      {
        ParallelLoop(threads, nanoseconds,
          [&](int range)
          {
            const std::size_t first = count * range / threads;
            const std::size_t size = count * (range + 1) / threads - first;
            for (std::size_t i = 0; i < elements; ++i)
            {
              forElement(i,
                [&](std::size_t bucket, const Value& value)
                {
                  if (bucket - first < size)
                  {
                    visit(bucket, value);
                  }
                });
            }
          });
      };
      forAll([&](std::size_t bucket, const Value&) { ++all.Begin[bucket + 2]; });
      all.AddUpSizes();
      forAll([&](std::size_t bucket, const Value& value)
        { all.Values[all.Begin[bucket + 1]++] = value; });
      return all;
    }
    ParallelLoop(elements, cost,
      [&](std::size_t i)
      { forElement(i, [&](std::size_t bucket, const Value&) { Next(all.Begin[bucket + 2]); }); });
    all.AddUpSizes();
    ParallelLoop(elements, cost,
      [&](std::size_t i)
      {
        forElement(i,
          [&](std::size_t bucket, const Value& value)
          { all.Values[Next(all.Begin[bucket + 1])] = value; });
      });
    return all;
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
  RawVector<Value> TakeAll() && { return std::move(this->Values); }

private:
  /** So few threads visit all elements each, for a range of buckets: that takes less time than
   * counting in turns. */
  static constexpr int MostRanges = 2;

  void AddUpSizes()
  {
    for (std::size_t bucket = 2; bucket < this->Begin.size(); ++bucket)
    {
      this->Begin[bucket] += this->Begin[bucket - 1];
    }
    this->Values.resize(this->Begin.back());
  }

  /** The value before it is increased by one, which threads do one after the other. */
  static std::size_t Next(std::size_t& value)
  {
    return __atomic_fetch_add(&value, std::size_t(1), __ATOMIC_RELAXED);
  }

  std::vector<std::size_t> Begin;
  RawVector<Value> Values;
};
} // namespace insideout
