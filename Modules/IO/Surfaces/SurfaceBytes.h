#pragma once

#include <cstddef>
#include <cstdint>
#include <string>
#include <string_view>

namespace palpate
{
enum class NumberCoding
{
  Text,
  LittleEndian,
  BigEndian
};

/// Type of a stored number: whole ones of 1, 2, 4 or 8 bytes, floating-point ones of 4 or 8.
struct NumberType
{
  std::size_t Bytes;
  bool Signed;
  bool Real;
};

/// At most 8 bytes as a whole number.
std::uint64_t BitsOf(std::string_view bytes, NumberCoding order);
/// As many bytes as the type has, as its number.
double NumberOf(std::string_view bytes, const NumberType& type, NumberCoding order);

/// Removes and returns the first word of a text; empty at the end.
std::string_view TakeWord(std::string_view& text);

/// The bytes of a surface file, which a reader takes from the front. Failures are an InputError:
/// "<file> is not a readable <format> surface: <fact>; write the file again."
class SurfaceBytes
{
public:
  /// The bytes and names have to outlive this object.
  SurfaceBytes(std::string_view bytes, const std::string& fileName, const char* format);

  NumberCoding Coding = NumberCoding::Text; ///< of what Number reads

  [[noreturn]] void Refuse(const std::string& fact) const;

  bool IsText() const { return this->Coding == NumberCoding::Text; }
  bool IsEmpty() const { return this->Rest.empty(); }
  /// Of the whole file.
  std::size_t Size() const { return this->WholeSize; }

  /// Without its line end.
  std::string_view Line();
  /// Empty at the end.
  std::string_view Word() { return TakeWord(this->Rest); }
  /// Refuses if there are fewer.
  std::string_view Bytes(std::size_t count);
  /// In a text, any finite number.
  double Number(const NumberType& type);

  /// A number or word as a count of things, of which the file has to hold at least a bit each.
  std::size_t CountOf(double number) const;
  std::size_t CountOf(std::string_view word) const;
  /// A number as an index, which may exceed the points (TrianglesOf checks that).
  int IndexOf(double number) const;
  /// The fewest bytes that a value takes.
  std::size_t LeastBytes(const NumberType& type) const { return this->IsText() ? 2 : type.Bytes; }
  /// Refuses counts that exceed the file; called before memory is reserved.
  void RequireRoom(std::size_t count, std::size_t leastBytes) const;

private:
  std::string_view Rest;
  std::size_t WholeSize;
  const std::string& FileName;
  const char* Format;
};
} // namespace palpate
