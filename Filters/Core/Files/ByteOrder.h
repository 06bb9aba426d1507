// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstddef>
#include <cstdint>
#include <cstring>
#include <type_traits>

/** Numbers in the byte order of a file, regardless of the machine's. */
namespace insideout
{
enum class ByteOrder
{
  Little,
  Big
};

/** The unsigned integer as wide as T. */
template <typename T>
using BitsOf = std::conditional_t<sizeof(T) == 1, std::uint8_t,
  std::conditional_t<sizeof(T) == 2, std::uint16_t,
    std::conditional_t<sizeof(T) == 4, std::uint32_t, std::uint64_t>>>;

/** The number in the sizeof(T) bytes at `bytes`, which may be unaligned. */
template <typename T>
T LoadNumber(const char* bytes, ByteOrder order)
{
  BitsOf<T> bits = 0;
  for (std::size_t i = 0; i < sizeof(T); ++i)
  {
    const std::size_t place = order == ByteOrder::Little ? i : sizeof(T) - 1 - i;
    const auto byte = static_cast<BitsOf<T>>(static_cast<unsigned char>(bytes[i]));
    bits = static_cast<BitsOf<T>>(bits | static_cast<BitsOf<T>>(byte << (8 * place)));
  }
  T value;
  std::memcpy(&value, &bits, sizeof(T));
  return value;
}

/** Store the number in the sizeof(T) bytes from `bytes` on, the lowest byte first. */
template <typename T>
void StoreLittleEndian(char* bytes, T value)
{
  BitsOf<T> bits;
  std::memcpy(&bits, &value, sizeof(T));
  for (std::size_t i = 0; i < sizeof(T); ++i)
  {
    bytes[i] = static_cast<char>(static_cast<unsigned char>(bits >> (8 * i)));
  }
}
} // namespace insideout
