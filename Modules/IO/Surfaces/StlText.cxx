#include "StlText.h"

#include "Refusal.h"
#include "SurfaceBytes.h"

#include <algorithm>
#include <cctype>
#include <charconv>
#include <cmath>
#include <string_view>

namespace palpate
{
namespace
{
bool IsStlWord(std::string_view word, std::string_view lowerCase)
{
  return word.size() == lowerCase.size() &&
         std::equal(word.begin(), word.end(), lowerCase.begin(),
                    [](unsigned char a, char b) { return std::tolower(a) == b; });
}

// In any case.
bool MentionsWord(const std::string& text, std::string_view lowerCase)
{
  return std::search(text.begin(), text.end(), lowerCase.begin(), lowerCase.end(),
                     [](unsigned char a, char b) { return std::tolower(a) == b; }) != text.end();
}

[[noreturn]] void RefuseStl(const std::string& file, const std::string& fact)
{
  Refuse(file, fact, "write the file again");
}

Vector3 ReadStlVertex(std::string_view& text, const std::string& file)
{
  Eigen::Vector3f place;
  for (float& coordinate : place)
  {
    std::string_view word = TakeWord(text);
    word.remove_prefix(word.rfind('+', 0) == 0 ? 1 : 0);
    const auto [end, error] = std::from_chars(word.data(), word.data() + word.size(), coordinate);
    if (error != std::errc() || end != word.data() + word.size() || !std::isfinite(coordinate))
    {
      RefuseStl(file, "is not a complete STL file: a vertex is not three numbers");
    }
  }
  return place.cast<double>();
}

// Three of each triangle.
std::vector<Vector3> ReadStlCorners(std::string_view text, const std::string& file)
{
  std::vector<Vector3> corners;
  bool isClosed = false;
  for (std::string_view word = TakeWord(text); !word.empty(); word = TakeWord(text))
  {
    if (IsStlWord(word, "solid") || IsStlWord(word, "endsolid"))
    {
      isClosed = IsStlWord(word, "endsolid");
      // Its name, of any length and words.
      text.remove_prefix(std::min(text.find_first_of("\r\n"), text.size()));
    }
    else if (IsStlWord(word, "vertex"))
    {
      corners.push_back(ReadStlVertex(text, file));
    }
    else if (IsStlWord(word, "endloop") && corners.size() % 3 != 0)
    {
      RefuseStl(file, "has a facet that is not a triangle");
    }
  }
  if (!isClosed || corners.size() % 3 != 0 || corners.empty())
  {
    RefuseStl(file, "is not a complete STL file (it may be truncated)");
  }
  return corners;
}
} // namespace

std::uint64_t BinaryStlBytes(const std::string& bytes)
{
  constexpr std::size_t Header = 80;
  constexpr std::size_t Count = 4;
  constexpr std::size_t Triangle = 50;
  const std::string_view count =
      std::string_view(bytes).substr(std::min(Header, bytes.size()), Count);
  return Header + Count +
         (count.size() == Count ? Triangle * BitsOf(count, NumberCoding::LittleEndian) : 0);
}

bool IsStlText(const std::string& bytes)
{
  return IsStlWord(std::string_view(bytes).substr(0, 5), "solid") &&
         bytes.size() != BinaryStlBytes(bytes) &&
         (MentionsWord(bytes, "facet") || MentionsWord(bytes, "endsolid"));
}

TriangleMesh MeshFromStlText(const std::string& text, const std::string& file)
{
  TriangleMesh mesh;
  mesh.PointsWorld = ReadStlCorners(text, file);
  mesh.SinglePrecision = true;
  for (int corner = 0; corner < static_cast<int>(mesh.PointsWorld.size()); corner += 3)
  {
    mesh.Triangles.push_back({corner, corner + 1, corner + 2});
  }
  MergeEqualPoints(mesh);
  return mesh;
}
} // namespace palpate
