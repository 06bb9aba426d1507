// SPDX-License-Identifier: GPL-3.0-or-later
#include "Files/SolidBuilder.h"
#include "Files/SolidReaders.h"

#include <algorithm>
#include <charconv>

// The format: Frey, MEDIT: An interactive mesh visualization software (2001); for quadratic cells,
// and the sections on the order of their points, Marechal, libMeshb.

namespace insideout
{
namespace
{
bool IsLetter(char c)
{
  return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z');
}

/** The points of an element: each is twice a corner, or the midpoint of two. */
using Places = std::vector<std::array<int, 2>>;

/** VTK's order, the default of files. */
Places UsualPlaces(std::size_t corners)
{
  Places places;
  for (int k = 0; k < static_cast<int>(corners); ++k)
  {
    places.push_back({ { k, k } });
  }
  if (corners == 3)
  {
    places.insert(places.end(), { { { 0, 1 } }, { { 1, 2 } }, { { 0, 2 } } });
    return places;
  }
  for (const std::array<int, 2>& edge : TetrahedronEdges)
  {
    places.push_back({ { std::min(edge[0], edge[1]), std::max(edge[0], edge[1]) } });
  }
  return places;
}

/** The content of one shape. */
struct Shape
{
  FileElements& Elements;
  Places Order; ///< order of quadratic elements in this file
};

class MeditReader
{
public:
  MeditReader(const FileContent& file, Monitor& monitor)
    : Scanner(file, file.TextBegin(), 1, { false, false }, monitor)
    , Builder(file)
    , Triangles{ Builder.Triangles, UsualPlaces(3) }
    , Tetrahedra{ Builder.Tetrahedra, UsualPlaces(4) }
  {
  }

  SolidContent Read()
  {
    this->ReadHeader();
    for (std::string keyword = this->Keyword(); keyword != "end"; keyword = this->Keyword())
    {
      this->ReadSection(keyword);
    }
    this->Reorder(this->Triangles);
    this->Reorder(this->Tetrahedra);
    return this->Builder.Finish();
  }

private:
  void ReadHeader()
  {
    if (!this->SkipToContent() || !EqualsIgnoringCase(this->Scanner.Word(), "meshversionformatted"))
    {
      this->Scanner.Fail("is not a file of Medit's: MeshVersionFormatted has to come first");
    }
    this->Integer();
  }

  /** The keyword of the next section, in lower case. */
  std::string Keyword()
  {
    // The content of unknown sections is not a keyword.
    while (this->SkipToContent() && !IsLetter(*this->Scanner.Position()))
    {
      this->Scanner.Word();
    }
    std::string keyword(this->Scanner.Word());
    if (keyword.empty())
    {
      this->Scanner.Fail("there is no End: the file is truncated");
    }
    std::transform(keyword.begin(), keyword.end(), keyword.begin(),
      [](char c) { return c >= 'A' && c <= 'Z' ? static_cast<char>(c - 'A' + 'a') : c; });
    return keyword;
  }

  void ReadSection(const std::string& keyword)
  {
    if (keyword == "dimension")
    {
      this->ReadDimension();
    }
    else if (keyword == "vertices")
    {
      this->ReadVertices();
    }
    else if (keyword == "triangles" || keyword == "tetrahedra")
    {
      this->ReadElements(keyword == "triangles" ? this->Triangles : this->Tetrahedra, false);
    }
    else if (keyword == "trianglesp2" || keyword == "tetrahedrap2")
    {
      this->ReadElements(keyword == "trianglesp2" ? this->Triangles : this->Tetrahedra, true);
    }
    else if (keyword == "trianglesp2ordering" || keyword == "tetrahedrap2ordering")
    {
      this->ReadOrder(keyword == "trianglesp2ordering" ? this->Triangles : this->Tetrahedra);
    }
    else
    {
      this->CountOthers(keyword);
    }
  }

  void ReadDimension()
  {
    this->Dimension = this->Integer();
    if (this->Dimension != 2 && this->Dimension != 3)
    {
      this->Scanner.Fail("the dimension is " + std::to_string(this->Dimension) + ", not 2 or 3");
    }
  }

  void ReadVertices()
  {
    constexpr std::uint64_t shortest = 6; // "0 0 0\n"
    const std::int64_t count = this->Count(shortest, "points");
    for (std::int64_t p = 0; p < count; ++p)
    {
      Point point = { { 0, 0, 0 } };
      for (std::size_t axis = 0; axis < static_cast<std::size_t>(this->Dimension); ++axis)
      {
        this->Need();
        point[axis] = this->Scanner.Number();
      }
      this->Integer(); // reference
      this->Builder.AddPoint(this->Scanner, ++this->Points, point);
    }
  }

  void ReadElements(Shape& shape, bool isQuadratic)
  {
    constexpr std::uint64_t shortest = 8; // "1 2 3 0\n"
    const std::int64_t count = this->Count(shortest, "elements");
    const std::size_t corners = shape.Elements.Corners;
    std::vector<std::int64_t> nodes(isQuadratic ? shape.Order.size() : corners);
    auto number = static_cast<std::int64_t>(shape.Elements.All.size());
    for (std::int64_t e = 0; e < count; ++e)
    {
      this->Need();
      FileElement element = { ++number, this->Scanner.GetLine() };
      for (std::int64_t& node : nodes)
      {
        node = this->Integer();
      }
      element.Group = this->Integer();
      SolidBuilder::AddElement(shape.Elements, element, nodes);
    }
  }

  /** The points of quadratic elements, by twice their barycentric coordinates. */
  void ReadOrder(Shape& shape)
  {
    const Places usual = shape.Order;
    if (this->Integer() != static_cast<std::int64_t>(usual.size()))
    {
      this->Scanner.Fail("an order is of " + std::to_string(usual.size()) + " points");
    }
    for (std::array<int, 2>& place : shape.Order)
    {
      int found = 0;
      for (std::size_t corner = 0; corner < shape.Elements.Corners; ++corner)
      {
        for (std::int64_t times = this->Integer(); times > 0 && found <= 2; --times, ++found)
        {
          place[static_cast<std::size_t>(found) % 2] = static_cast<int>(corner);
        }
      }
      if (found != 2)
      {
        this->Scanner.Fail("this is neither a corner nor the middle of an edge");
      }
    }
    if (!std::is_permutation(usual.begin(), usual.end(), shape.Order.begin()))
    {
      this->Scanner.Fail("the order of an element's points has one of them twice");
    }
  }

  /** Bring the midpoints into VTK's order. */
  static void Reorder(const Shape& shape)
  {
    const Places usual = UsualPlaces(shape.Elements.Corners);
    std::vector<std::int64_t>& all = shape.Elements.Nodes;
    for (const FileElement& element : shape.Elements.All)
    {
      if (!element.IsQuadratic)
      {
        continue;
      }
      const auto begin = all.begin() + static_cast<std::ptrdiff_t>(element.Begin);
      const std::vector<std::int64_t> nodes(
        begin, begin + static_cast<std::ptrdiff_t>(usual.size()));
      for (std::size_t k = 0; k < usual.size(); ++k)
      {
        const auto place = std::find(usual.begin(), usual.end(), shape.Order[k]);
        begin[place - usual.begin()] = nodes[k];
      }
    }
  }

  /** Other cells that parts of a solid may be made of. */
  void CountOthers(const std::string& keyword)
  {
    for (const char* shape : { "quadrilaterals", "hexahedra", "prisms", "pyramids" })
    {
      const bool isThis = keyword.compare(0, std::string(shape).size(), shape) == 0;
      const bool isOrder = keyword.find("ordering") != std::string::npos;
      if (isThis && !isOrder)
      {
        constexpr std::uint64_t shortest = 10; // "1 2 3 4 0\n"
        this->Builder.AddOthers(shape, this->Count(shortest, shape));
      }
    }
  }

  std::int64_t Count(std::uint64_t shortest, const char* things)
  {
    const std::int64_t count = this->Integer();
    CheckAnnounced(this->Scanner, count, shortest, things);
    return count;
  }

  std::int64_t Integer()
  {
    this->Need();
    return this->Scanner.Integer();
  }

  void Need()
  {
    if (!this->SkipToContent())
    {
      this->Scanner.Fail("the file is truncated");
    }
  }

  /** Skip blanks, line ends and comments; comments by vtkSolidWriter name groups. */
  bool SkipToContent()
  {
    while (this->Scanner.SkipToContent() && *this->Scanner.Position() == '#')
    {
      const char* const begin = this->Scanner.Position();
      this->Scanner.SkipLine();
      this->ReadComment({ begin, static_cast<std::size_t>(this->Scanner.Position() - begin) });
    }
    return this->Scanner.Left() > 0;
  }

  void ReadComment(std::string_view comment)
  {
    for (FileElements* elements : { &this->Builder.Triangles, &this->Builder.Tetrahedra })
    {
      const std::string begin = elements == &this->Builder.Triangles
        ? "# Triangles with reference "
        : "# Tetrahedra with reference ";
      std::int64_t number = 0;
      const char* const digits = comment.data() + std::min(begin.size(), comment.size());
      const char* const end =
        comment.data() + std::min(comment.find_last_not_of("\r\n") + 1, comment.size());
      if (comment.substr(0, begin.size()) != begin || end < digits)
      {
        continue;
      }
      const std::from_chars_result result = std::from_chars(digits, end, number);
      if (result.ec == std::errc() && end - result.ptr > 2 && result.ptr[0] == ':')
      {
        elements->NamesOfGroups[number] = std::string(result.ptr + 2, end);
      }
    }
  }

  TextScanner Scanner;
  SolidBuilder Builder;
  Shape Triangles;
  Shape Tetrahedra;
  std::int64_t Dimension = 3;
  std::int64_t Points = 0;
};
} // namespace

SolidContent ReadMedit(const FileContent& file, Monitor& monitor)
{
  return MeditReader(file, monitor).Read();
}
} // namespace insideout
