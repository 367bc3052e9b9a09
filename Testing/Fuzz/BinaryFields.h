#pragma once

#include "Mutation.h"

namespace palpate::test
{
enum class ByteOrder
{
  Little,
  Big
};

/// A number in a binary header.
struct BinaryField
{
  enum class Type
  {
    Integer,
    Real ///< of 4 or 8 bytes
  };
  std::size_t Offset = 0;
  std::size_t Bytes = 4; ///< 1, 2, 4 or 8
  Type Kind = Type::Integer;
};

/// `count` adjacent fields.
std::vector<BinaryField> FieldsFrom(std::size_t offset, std::size_t count, std::size_t bytes,
                                    BinaryField::Type kind = BinaryField::Type::Integer);

/// Overwrites a field with a boundary value (see OddInteger and OddReal). Ignored if the field lies
/// beyond the end.
void ChangeField(std::string& bytes, const BinaryField& field, ByteOrder order, Random& random);

/// Changes one to three fields of a table.
Mutator FieldMutator(std::vector<BinaryField> table, ByteOrder order = ByteOrder::Little);
} // namespace palpate::test
