#include "GiftiReader.h"

#include "Base64Text.h"
#include "DecimalText.h"
#include "GiftiText.h"
#include "Refusal.h"
#include "SurfaceBytes.h"

#include <Eigen/LU>
#include <algorithm>
#include <cmath>
#include <string_view>
#include <utility>
#include <vector>
#include <zlib.h>

namespace palpate
{
namespace
{
// Coordinates compress to about a half and triangles to a tenth.
constexpr std::size_t MostGiftiBytesFromByte = 100;
constexpr NumberType SingleNumber{4, true, true};
constexpr NumberType DoubleNumber{8, true, true};
constexpr NumberType WholeNumber{4, true, false};

/// Decodes the arrays of one file.
class Decoder
{
public:
  explicit Decoder(const std::string& name) : FileName(name) {}

  [[noreturn]] void Refuse(const std::string& fact) const
  {
    palpate::Refuse(this->FileName, "is not a readable GIfTI surface: " + fact, "write it again");
  }

  // The numbers of triples, one after the other.
  std::vector<double> Triples(const GiftiArray& array, const NumberType& type) const
  {
    const std::size_t count = this->TripleCount(array);
    const std::vector<double> numbers = array.Encoding == "ASCII"
                                            ? this->TextNumbers(array.Data, 3 * count, type)
                                            : this->BinaryNumbers(array, 3 * count, type);
    if (array.Order != "ColumnMajorOrder")
    {
      return numbers;
    }
    std::vector<double> byRows;
    byRows.reserve(3 * count);
    for (std::size_t i = 0; i < 3 * count; ++i)
    {
      byRows.push_back(numbers[i % 3 * count + i / 3]);
    }
    return byRows;
  }

  // Row by row.
  Eigen::Matrix4d Matrix(const std::string& text) const
  {
    const std::vector<double> numbers = this->TextNumbers(text, 16, DoubleNumber);
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

  std::vector<double> TextNumbers(std::string_view text, std::size_t count,
                                  const NumberType& type) const
  {
    std::vector<double> numbers;
    numbers.reserve(std::min(count, text.size()));
    while (numbers.size() < count)
    {
      numbers.push_back(this->Number(TakeWord(text), type));
    }
    if (!TakeWord(text).empty())
    {
      this->Refuse("it has more values than it states");
    }
    return numbers;
  }

  double Number(std::string_view word, const NumberType& type) const
  {
    auto number = ParseNumber(word);
    if (number && type.Bytes == sizeof(float))
    {
      number = static_cast<float>(*number);
    }
    if (!type.Real)
    {
      number = ParseInteger(word);
    }
    if (!number || !std::isfinite(*number))
    {
      this->Refuse("a value is missing, not a number or too large");
    }
    return *number;
  }

  std::vector<double> BinaryNumbers(const GiftiArray& array, std::size_t count,
                                    const NumberType& type) const
  {
    const bool isPacked = array.Encoding == "GZipBase64Binary";
    if (!isPacked && array.Encoding != "Base64Binary")
    {
      this->Refuse("its values are not in the file itself");
    }
    auto bytes = DecodedBase64(array.Data);
    if (!bytes)
    {
      this->Refuse("its Base64 text is damaged");
    }
    const std::size_t size = count * type.Bytes;
    if (size > (isPacked ? MostGiftiBytesFromByte : 1) * bytes->size())
    {
      this->Refuse("it states more values than it can hold");
    }
    if (isPacked)
    {
      bytes = this->Inflated(*bytes, size);
    }
    this->RequireLength(bytes->size() == size);
    std::vector<double> numbers;
    numbers.reserve(count);
    for (std::string_view left = *bytes; !left.empty(); left.remove_prefix(type.Bytes))
    {
      numbers.push_back(NumberOf(left.substr(0, type.Bytes), type,
                                 array.Endian == "BigEndian" ? NumberCoding::BigEndian
                                                             : NumberCoding::LittleEndian));
    }
    return numbers;
  }

  // zlib or gzip by the first bytes: the format's name says gzip, but programs write zlib.
  std::string Inflated(const std::string& packed, std::size_t bytes) const
  {
    std::string unpacked(bytes, '\0');
    z_stream stream{};
    inflateInit2(&stream, MAX_WBITS + 32);
    stream.next_in = reinterpret_cast<Bytef*>(const_cast<char*>(packed.data()));
    stream.avail_in = static_cast<uInt>(packed.size());
    stream.next_out = reinterpret_cast<Bytef*>(unpacked.data());
    stream.avail_out = static_cast<uInt>(bytes);
    const bool isWide = bytes > 0xffffffffU || packed.size() > 0xffffffffU;
    const int state = isWide ? Z_DATA_ERROR : inflate(&stream, Z_FINISH);
    const bool isFull = stream.avail_out == 0;
    inflateEnd(&stream);
    this->RequireLength(state == Z_STREAM_END && isFull);
    return unpacked;
  }

  void RequireLength(bool isRight) const
  {
    if (!isRight)
    {
      this->Refuse("its values are damaged, or not as many as it states");
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
  const std::vector<double> numbers =
      decoder.Triples(array, mesh.SinglePrecision ? SingleNumber : DoubleNumber);
  for (std::size_t i = 0; i < numbers.size(); i += 3)
  {
    mesh.PointsWorld.emplace_back(numbers[i], numbers[i + 1], numbers[i + 2]);
  }
}

void TakeTriangles(const Decoder& decoder, const GiftiArray& array, TriangleMesh& mesh)
{
  if (array.Type != "NIFTI_TYPE_INT32")
  {
    decoder.Refuse("its triangles are not 32-bit integers");
  }
  const std::vector<double> corners = decoder.Triples(array, WholeNumber);
  for (std::size_t i = 0; i < corners.size(); i += 3)
  {
    mesh.Triangles.push_back({static_cast<int>(corners[i]), static_cast<int>(corners[i + 1]),
                              static_cast<int>(corners[i + 2])});
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
  TriangleMesh mesh;
  TakePoints(decoder, *arrays.Points, mesh);
  TakeTriangles(decoder, *arrays.Triangles, mesh);
  if (arrays.Points->ToScanner)
  {
    MoveToScanner(decoder, *arrays.Points->ToScanner, mesh);
  }
  return mesh;
}
} // namespace palpate
