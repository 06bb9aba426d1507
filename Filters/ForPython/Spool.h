// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   Spool
 * @brief   keeps in memory what a stream writes, and never fails meanwhile
 *
 * VTK's XML writers go back to what they wrote, and crash when their stream fails. Here they cannot
 * see it fail: when there is no memory left the rest is thrown away, and MoveTo says so.
 */
#pragma once

#include <array>
#include <ios>
#include <memory>
#include <streambuf>
#include <vector>

namespace insideout
{
class OutputFile;
}

namespace vtkInsideOut
{
class Spool : public std::streambuf
{
public:
  Spool();
  ~Spool() override;

  /**
   * Write it to a file. Bytes that are written leave the memory.
   * @throws std::bad_alloc if it is not all there; Error of the file
   */
  void MoveTo(insideout::OutputFile& file);

protected:
  int_type overflow(int_type character) override;
  pos_type seekoff(off_type offset, std::ios::seekdir from, std::ios::openmode which) override;
  pos_type seekpos(pos_type position, std::ios::openmode which) override;

private:
  static constexpr std::size_t PieceLength = std::size_t(1) << 20;
  using Piece = std::array<char, PieceLength>;

  std::size_t Position() const;
  void GoTo(std::size_t position);

  std::vector<std::unique_ptr<Piece>> Pieces; ///< the first is always there
  std::size_t Current = 0;                    ///< the piece that is written to
  std::size_t Length = 0;                     ///< of all, but for what was written since GoTo
  bool Complete = true;
};
} // namespace vtkInsideOut
