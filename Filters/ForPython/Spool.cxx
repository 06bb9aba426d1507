// SPDX-License-Identifier: GPL-3.0-or-later
#include "ForPython/Spool.h"

#include "Files/OutputFile.h"

#include <algorithm>
#include <new>

namespace vtkInsideOut
{
Spool::Spool()
{
  this->Pieces.emplace_back(new Piece);
  this->GoTo(0);
}

Spool::~Spool() = default;

void Spool::MoveTo(insideout::OutputFile& file)
{
  this->Length = std::max(this->Length, this->Position());
  if (!this->Complete)
  {
    throw std::bad_alloc();
  }
  for (std::size_t begin = 0; begin < this->Length; begin += PieceLength)
  {
    std::unique_ptr<Piece>& piece = this->Pieces[begin / PieceLength];
    file.Text({ piece->data(), std::min(PieceLength, this->Length - begin) });
    piece.reset();
  }
}

std::streambuf::int_type Spool::overflow(int_type character)
{
  this->GoTo(this->Position());
  if (!traits_type::eq_int_type(character, traits_type::eof()))
  {
    *this->pptr() = traits_type::to_char_type(character);
    this->pbump(1);
  }
  return traits_type::not_eof(character);
}

std::streambuf::pos_type Spool::seekoff(
  off_type offset, std::ios::seekdir from, std::ios::openmode which)
{
  const std::size_t here = this->Position();
  const std::size_t base = from == std::ios::beg ? 0
    : from == std::ios::cur                      ? here
                                                 : std::max(this->Length, here);
  return this->seekpos(static_cast<off_type>(base) + offset, which);
}

std::streambuf::pos_type Spool::seekpos(pos_type position, std::ios::openmode)
{
  this->GoTo(static_cast<std::size_t>(off_type(position)));
  return position;
}

std::size_t Spool::Position() const
{
  return this->Current * PieceLength + static_cast<std::size_t>(this->pptr() - this->pbase());
}

void Spool::GoTo(std::size_t position)
{
  if (this->pptr())
  {
    this->Length = std::max(this->Length, this->Position());
  }
  this->Current = position / PieceLength;
  try
  {
    while (this->Pieces.size() <= this->Current)
    {
      this->Pieces.emplace_back(new Piece);
    }
  }
  catch (const std::bad_alloc&)
  {
    this->Complete = false;
  }
  // Without memory the rest overwrites the first chunk, which is not needed any more.
  Piece& piece = *this->Pieces[this->Complete ? this->Current : 0];
  this->setp(piece.data(), piece.data() + piece.size());
  this->pbump(static_cast<int>(position % PieceLength));
}
} // namespace vtkInsideOut
