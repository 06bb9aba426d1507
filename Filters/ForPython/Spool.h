// SPDX-License-Identifier: GPL-3.0-or-later
/**
 * @class   Spool
 * @brief an in-memory stream buffer whose writes never fail
 *
 * VTK's XML writers seek back, and crash when their stream fails. This buffer hides failures from
 * them: without memory the rest is discarded, and MoveTo reports it.
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
   * Write it to a file, freeing the memory of written bytes.
   * @throws std::bad_alloc if it is incomplete; Error of the file
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

  std::vector<std::unique_ptr<Piece>> Pieces; ///< the first always exists
  std::size_t Current = 0;                    ///< the chunk being written to
  std::size_t Length = 0;                     ///< total size, without bytes written since GoTo
  bool Complete = true;
};
} // namespace vtkInsideOut
