#include "GiftiReader.h"

#include "Base64Text.h"
#include "DecimalText.h"
#include "GiftiText.h"
#include "Refusal.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <cstdint>
#include <cstring>
#include <string_view>
#include <utility>
#include <zlib.h>

namespace palpate
{
namespace
{
// Coordinates compress to about a half and triangles to a tenth.
constexpr std::size_t MostGiftiBytesFromByte = 100;

/// Decodes the arrays of one file.
class Decoder
{
public:
  explicit Decoder(const std::string& name) : FileName(name) {}

  [[noreturn]] void Refuse(const std::string& fact) const
  {
    palpate::Refuse(this->FileName, "is not a readable GIfTI surface: " + fact, "write it again");
  }

  // Triples of numbers; `Stored` is their type in the file.
  template <typename Stored, typename Number>
  std::vector<std::array<Number, 3>> Triples(const GiftiArray& array) const
  {
    const std::size_t count = this->TripleCount(array);
    const std::vector<Stored> numbers = array.Encoding == "ASCII"
                                            ? this->TextNumbers<Stored>(array.Data, 3 * count)
                                            : this->BinaryNumbers<Stored>(array, 3 * count);
    const bool byColumns = array.Order == "ColumnMajorOrder";
    std::vector<std::array<Number, 3>> triples(count);
    for (std::size_t i = 0; i < count; ++i)
    {
      for (std::size_t k = 0; k < 3; ++k)
      {
        triples[i][k] = static_cast<Number>(numbers[byColumns ? k * count + i : 3 * i + k]);
      }
    }
    return triples;
  }

  // Row by row.
  Eigen::Matrix4d Matrix(const std::string& text) const
  {
    const std::vector<double> numbers = this->TextNumbers<double>(text, 16);
    return Eigen::Map<const Eigen::Matrix<double, 4, 4, Eigen::RowMajor>>(numbers.data());
  }

private:
  std::size_t TripleCount(const GiftiArray& array) const
  {
    const int count = ParseInteger(array.Sizes[0]).value_or(0);
    if (count < 1 || ParseInteger(array.Sizes[1]) != 3)
    {
      this->Refuse("its points or triangles are not triples");
    }
    // Even one digit and one blank each, or the strongest compression, take some bytes.
    if (static_cast<std::size_t>(count) > MostGiftiBytesFromByte * array.Data.size())
    {
      this->Refuse("it states more values than it can hold");
    }
    return static_cast<std::size_t>(count);
  }

  template <typename Stored>
  std::vector<Stored> TextNumbers(std::string_view text, std::size_t count) const
  {
    constexpr std::string_view Blanks = " \t\r\n";
    std::vector<Stored> numbers;
    numbers.reserve(std::min(count, text.size()));
    while (numbers.size() < count)
    {
      text.remove_prefix(std::min(text.find_first_not_of(Blanks), text.size()));
      const std::string_view word = text.substr(0, text.find_first_of(Blanks));
      text.remove_prefix(word.size());
      numbers.push_back(this->Number<Stored>(word));
    }
    if (text.find_first_not_of(Blanks) != std::string_view::npos)
    {
      this->Refuse("it has more values than it states");
    }
    return numbers;
  }

  template <typename Stored>
  Stored Number(std::string_view word) const
  {
    bool isThere = false;
    Stored number = 0;
    if constexpr (std::is_integral_v<Stored>)
    {
      const auto value = ParseInteger(word);
      isThere = value.has_value();
      number = value.value_or(0);
    }
    else
    {
      const auto value = ParseNumber(word);
      isThere = value && std::isfinite(static_cast<Stored>(*value));
      number = static_cast<Stored>(value.value_or(0.0));
    }
    if (!isThere)
    {
      this->Refuse("a value is missing, not a number or too large");
    }
    return number;
  }

  template <typename Stored>
  std::vector<Stored> BinaryNumbers(const GiftiArray& array, std::size_t count) const
  {
    const bool isPacked = array.Encoding == "GZipBase64Binary";
    if (!isPacked && array.Encoding != "Base64Binary")
    {
      this->Refuse("its values are not in the file itself");
    }
    const auto decoded = DecodedBase64(array.Data);
    if (!decoded)
    {
      this->Refuse("its Base64 text is damaged");
    }
    std::vector<Stored> numbers;
    const std::size_t bytes = count * sizeof(Stored);
    if (bytes > (isPacked ? MostGiftiBytesFromByte : 1) * decoded->size())
    {
      this->Refuse("it states more values than it can hold");
    }
    numbers.resize(count);
    if (isPacked)
    {
      this->Inflate(*decoded, numbers.data(), bytes);
    }
    else
    {
      this->RequireLength(decoded->size() == bytes);
      std::memcpy(numbers.data(), decoded->data(), bytes);
    }
    ToOwnOrder(array.Endian, numbers);
    return numbers;
  }

  // zlib or gzip by the first bytes: the format's name says gzip, but programs write zlib.
  void Inflate(const std::string& packed, void* target, std::size_t bytes) const
  {
    z_stream stream{};
    inflateInit2(&stream, MAX_WBITS + 32);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = static_cast<Bytef*>(target);
    stream.avail_out = static_cast<uInt>(bytes);
    const bool isWide = bytes > 0xffffffffU || packed.size() > 0xffffffffU;
    const int state = isWide ? Z_DATA_ERROR : inflate(&stream, Z_FINISH);
    const bool isFull = stream.avail_out == 0;
    inflateEnd(&stream);
    this->RequireLength(state == Z_STREAM_END && isFull);
  }

  void RequireLength(bool isRight) const
  {
    if (!isRight)
    {
      this->Refuse("its values are damaged, or not as many as it states");
    }
  }

  template <typename Stored>
  static void ToOwnOrder(const std::string& endian, std::vector<Stored>& numbers)
  {
    const std::uint16_t one = 1;
    unsigned char first = 0;
    std::memcpy(&first, &one, 1);
    if ((endian == "BigEndian") == (first == 1))
    {
      for (Stored& number : numbers)
      {
        auto* bytes = reinterpret_cast<unsigned char*>(&number);
        std::reverse(bytes, bytes + sizeof(Stored));
      }
    }
  }

  const std::string& FileName;
};

void TakePoints(const Decoder& decoder, const GiftiArray& array, TriangleMesh& mesh)
{
  mesh.SinglePrecision = array.Type == "NIFTI_TYPE_FLOAT32";
  if (!mesh.SinglePrecision && array.Type != "NIFTI_TYPE_FLOAT64")
  {
    decoder.Refuse("its points are not floating-point numbers");
  }
  const auto points = mesh.SinglePrecision ? decoder.Triples<float, double>(array)
                                           : decoder.Triples<double, double>(array);
  mesh.PointsWorld.reserve(points.size());
  for (const auto& point : points)
  {
    mesh.PointsWorld.emplace_back(point[0], point[1], point[2]);
  }
}

void MoveToScanner(const Decoder& decoder, const std::string& text, TriangleMesh& mesh)
{
  const Eigen::Matrix4d matrix = decoder.Matrix(text);
  const bool isAffine = matrix.row(3) == Eigen::RowVector4d(0, 0, 0, 1);
  const double volume = matrix.topLeftCorner<3, 3>().determinant();
  if (!isAffine || !std::isnormal(volume))
  {
    decoder.Refuse("its transform is not invertible");
  }
  for (Vector3& point : mesh.PointsWorld)
  {
    point = matrix.topRows<3>() * point.homogeneous();
  }
  // A reflection would turn the surface inside out.
  for (std::size_t i = 0; volume < 0.0 && i < mesh.Triangles.size(); ++i)
  {
    std::swap(mesh.Triangles[i][1], mesh.Triangles[i][2]);
  }
}
} // namespace

TriangleMesh MeshFromGifti(const std::string& text, const std::string& fileName)
{
  const Decoder decoder(fileName);
  const GiftiArrays arrays = GiftiArraysOf(text, fileName);
  if (!arrays.Points || !arrays.Triangles)
  {
    Refuse(fileName, "has no points and triangles (it may hold values on a surface)",
           "use the surface that they belong to (.surf.gii)");
  }
  if (arrays.Triangles->Type != "NIFTI_TYPE_INT32")
  {
    decoder.Refuse("its triangles are not 32-bit integers");
  }
  TriangleMesh mesh;
  TakePoints(decoder, *arrays.Points, mesh);
  mesh.Triangles = decoder.Triples<std::int32_t, int>(*arrays.Triangles);
  if (arrays.Points->ToScanner)
  {
    MoveToScanner(decoder, *arrays.Points->ToScanner, mesh);
  }
  return mesh;
}
} // namespace palpate
