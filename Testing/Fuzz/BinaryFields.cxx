#include "BinaryFields.h"

#include <cstring>
#include <utility>

namespace palpate::test
{
namespace
{
std::size_t PlaceOf(const BinaryField& field, std::size_t byte, ByteOrder order)
{
  return field.Offset + (order == ByteOrder::Little ? byte : field.Bytes - 1 - byte);
}

std::uint64_t Get(const std::string& bytes, const BinaryField& field, ByteOrder order)
{
  std::uint64_t value = 0;
  for (std::size_t byte = field.Bytes; byte-- > 0;)
  {
    value = value << 8 | static_cast<unsigned char>(bytes[PlaceOf(field, byte, order)]);
  }
  return value;
}

void Put(std::string& bytes, const BinaryField& field, ByteOrder order, std::uint64_t value)
{
  for (std::size_t byte = 0; byte < field.Bytes; ++byte)
  {
    bytes[PlaceOf(field, byte, order)] = static_cast<char>(value & 255);
    value >>= 8;
  }
}

template <typename Real, typename Word>
std::uint64_t OddBits(std::uint64_t present, Random& random)
{
  const Word word = static_cast<Word>(present);
  Real real;
  std::memcpy(&real, &word, sizeof(real));
  real = static_cast<Real>(OddReal(static_cast<double>(real), random));
  Word odd;
  std::memcpy(&odd, &real, sizeof(real));
  return odd;
}
} // namespace

std::vector<BinaryField> FieldsFrom(std::size_t offset, std::size_t count, std::size_t bytes,
                                    BinaryField::Type kind)
{
  std::vector<BinaryField> fields;
  for (std::size_t i = 0; i < count; ++i)
  {
    fields.push_back({offset + i * bytes, bytes, kind});
  }
  return fields;
}

void ChangeField(std::string& bytes, const BinaryField& field, ByteOrder order, Random& random)
{
  if (field.Offset > bytes.size() || field.Bytes > bytes.size() - field.Offset)
  {
    return;
  }
  const std::uint64_t present = Get(bytes, field, order);
  std::uint64_t odd = 0;
  if (field.Kind == BinaryField::Type::Integer)
  {
    odd = OddInteger(present, random);
  }
  else
  {
    odd = field.Bytes == 4 ? OddBits<float, std::uint32_t>(present, random)
                           : OddBits<double, std::uint64_t>(present, random);
  }
  Put(bytes, field, order, odd);
}

Mutator FieldMutator(std::vector<BinaryField> table, ByteOrder order)
{
  return [fields = std::move(table), order](std::string& bytes, Random& random)
  {
    for (std::size_t changes = 1 + Below(random, 3); changes > 0; --changes)
    {
      ChangeField(bytes, Choose(fields, random), order, random);
    }
  };
}
} // namespace palpate::test
