#include "SurfaceBytes.h"

#include "DecimalText.h"
#include "Refusal.h"

#include <algorithm>
#include <cmath>
#include <cstring>

namespace palpate
{
namespace
{
constexpr double MostIndex = 2147483647.0;
constexpr const char* Early = "it ends too early";

template <typename Real, typename Bits>
double RealOf(Bits bits)
{
  Real value = 0;
  std::memcpy(&value, &bits, sizeof value);
  return value;
}
} // namespace

std::uint64_t BitsOf(std::string_view bytes, NumberCoding order)
{
  std::uint64_t bits = 0;
  for (std::size_t i = 0; i < bytes.size(); ++i)
  {
    const std::size_t from = order == NumberCoding::BigEndian ? i : bytes.size() - 1 - i;
    bits = bits << 8 | static_cast<unsigned char>(bytes[from]);
  }
  return bits;
}

double NumberOf(std::string_view bytes, const NumberType& type, NumberCoding order)
{
  const std::uint64_t bits = BitsOf(bytes, order);
  if (type.Real)
  {
    return type.Bytes == sizeof(double) ? RealOf<double>(bits)
                                        : RealOf<float>(static_cast<std::uint32_t>(bits));
  }
  const std::size_t unused = 64 - 8 * type.Bytes;
  return type.Signed ? static_cast<double>(static_cast<std::int64_t>(bits << unused) >> unused)
                     : static_cast<double>(bits);
}

std::string_view TakeWord(std::string_view& text)
{
  constexpr std::string_view Blanks = " \t\r\n\v\f";
  text.remove_prefix(std::min(text.find_first_not_of(Blanks), text.size()));
  const std::string_view word = text.substr(0, text.find_first_of(Blanks));
  text.remove_prefix(word.size());
  return word;
}

SurfaceBytes::SurfaceBytes(std::string_view bytes, const std::string& fileName, const char* format)
    : Rest(bytes), WholeSize(bytes.size()), FileName(fileName), Format(format)
{
}

void SurfaceBytes::Refuse(const std::string& fact) const
{
  palpate::Refuse(this->FileName,
                  std::string("is not a readable ") + this->Format + " surface: " + fact,
                  "write the file again");
}

std::string_view SurfaceBytes::Line()
{
  std::string_view line = this->Rest.substr(0, this->Rest.find('\n'));
  this->Rest.remove_prefix(std::min(line.size() + 1, this->Rest.size()));
  line.remove_suffix(!line.empty() && line.back() == '\r' ? 1 : 0);
  return line;
}

std::string_view SurfaceBytes::Bytes(std::size_t count)
{
  if (count > this->Rest.size())
  {
    this->Refuse(Early);
  }
  const std::string_view bytes = this->Rest.substr(0, count);
  this->Rest.remove_prefix(count);
  return bytes;
}

double SurfaceBytes::Number(const NumberType& type)
{
  if (!this->IsText())
  {
    return NumberOf(this->Bytes(type.Bytes), type, this->Coding);
  }
  const std::string_view word = this->Word();
  const auto number = ParseNumber(word);
  if (!number)
  {
    this->Refuse(word.empty() ? Early : "it holds a value that is not a finite number");
  }
  return *number;
}

std::size_t SurfaceBytes::CountOf(double number) const
{
  if (!(number >= 0.0 &&
        number <= std::min(8.0 * static_cast<double>(this->WholeSize), MostIndex)) ||
      number != std::floor(number))
  {
    this->Refuse("one of its counts is invalid");
  }
  return static_cast<std::size_t>(number);
}

std::size_t SurfaceBytes::CountOf(std::string_view word) const
{
  return this->CountOf(ParseNumber(word).value_or(-1.0));
}

int SurfaceBytes::IndexOf(double number) const
{
  if (!(number >= 0.0 && number <= MostIndex) || number != std::floor(number))
  {
    this->Refuse("a cell refers to a point that does not exist");
  }
  return static_cast<int>(number);
}

void SurfaceBytes::RequireRoom(std::size_t count, std::size_t leastBytes) const
{
  // In a text, the last value needs no blank behind it.
  const std::size_t room = this->Rest.size() + (this->IsText() ? 1 : 0);
  if (count > 0 && (leastBytes == 0 || count > room / leastBytes))
  {
    this->Refuse(Early);
  }
}
} // namespace palpate
