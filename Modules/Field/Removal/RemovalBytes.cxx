#include "RemovalBytes.h"

#include "RemovalStroke.h"

#include <algorithm>
#include <cmath>
#include <cstring>
#include <type_traits>

namespace palpate
{
namespace
{
constexpr std::uint32_t Mark = 0x31766d52; // "Rmv1"
constexpr std::uint32_t Uniform = 1;

// Writes consecutive numbers.
class Writer
{
public:
  template <typename T>
  void Put(T number)
  {
    static_assert(std::is_arithmetic_v<T>);
    std::byte bytes[sizeof(T)];
    std::memcpy(bytes, &number, sizeof(T));
    this->Bytes.insert(this->Bytes.end(), bytes, bytes + sizeof(T));
  }
  std::vector<std::byte> Bytes;
};

class Reader
{
public:
  explicit Reader(const std::vector<std::byte>& bytes) : Bytes(bytes) {}

  template <typename T>
  T Take()
  {
    T number{};
    this->IsGood = this->IsGood && this->Bytes.size() - this->At >= sizeof(T);
    if (this->IsGood)
    {
      std::memcpy(&number, &this->Bytes[this->At], sizeof(T));
      this->At += sizeof(T);
    }
    return number;
  }
  bool HasAllTaken() const { return this->IsGood && this->At == this->Bytes.size(); }
  bool IsGood = true;

private:
  const std::vector<std::byte>& Bytes;
  std::size_t At = 0;
};

Status Broken()
{
  return Status::Failure("The bytes are not a state of removal.");
}

// Properties that must match for distances to be comparable.
std::vector<double> FrameOf(const RemovedDistances& removed)
{
  const FieldGrid& grid = removed.Grid();
  std::vector<double> frame{removed.Band()};
  frame.insert(frame.end(), grid.Size().begin(), grid.Size().end());
  frame.insert(frame.end(), grid.OriginWorld().begin(), grid.OriginWorld().end());
  frame.insert(frame.end(), grid.Spacing().begin(), grid.Spacing().end());
  frame.insert(frame.end(), grid.Direction().reshaped().begin(), grid.Direction().reshaped().end());
  return frame;
}
} // namespace

std::vector<std::byte> BytesOf(const RemovedDistances& removed)
{
  const std::vector<RemovedDistances::Corner> corners = removed.Corners();
  Writer writer;
  writer.Put(Mark);
  for (const double number : FrameOf(removed))
  {
    writer.Put(number);
  }
  writer.Put(static_cast<std::uint64_t>(corners.size()));
  for (const RemovedDistances::Corner& corner : corners)
  {
    const float* block = removed.BlockAt(corner);
    const float* end = block + RemovedDistances::NodesOfBlock;
    const bool isUniform = std::all_of(block, end, [block](float d) { return d == *block; });
    for (const int node : corner)
    {
      writer.Put(static_cast<std::int32_t>(node));
    }
    writer.Put(isUniform ? Uniform : std::uint32_t{0});
    std::for_each(block, isUniform ? block + 1 : end, [&writer](float d) { writer.Put(d); });
  }
  return std::move(writer.Bytes);
}

Status RemovedFromBytes(const std::vector<std::byte>& bytes, const RemovedDistances& like,
                        std::shared_ptr<const RemovedDistances>& removed)
{
  Reader reader(bytes);
  if (reader.Take<std::uint32_t>() != Mark)
  {
    return Broken();
  }
  bool isSame = true;
  for (const double number : FrameOf(like))
  {
    isSame = isSame && reader.Take<double>() == number;
  }
  if (!reader.IsGood || !isSame)
  {
    return reader.IsGood ? Status::Failure("The removal belongs to another volume, or to "
                                           "another material of it.")
                         : Broken();
  }
  const auto limit = static_cast<float>(like.Band());
  const auto isDistance = [limit](float d) { return d >= -limit && d <= limit; };
  RemovalStroke stroke(RemovedDistances::None(like.Grid(), like.Band()));
  RemovalStroke::Nodes nodes{};
  const auto count = reader.Take<std::uint64_t>();
  for (std::uint64_t n = 0; n < count && reader.IsGood; ++n)
  {
    RemovedDistances::Corner corner{};
    for (int& node : corner)
    {
      node = reader.Take<std::int32_t>();
    }
    if (reader.Take<std::uint32_t>() == Uniform)
    {
      nodes.fill(reader.Take<float>());
    }
    else
    {
      std::generate(nodes.begin(), nodes.end(), [&reader] { return reader.Take<float>(); });
    }
    if (!reader.IsGood || !std::all_of(nodes.begin(), nodes.end(), isDistance) ||
        !stroke.Set(corner, nodes))
    {
      return Broken();
    }
  }
  if (!reader.HasAllTaken())
  {
    return Broken();
  }
  removed = stroke.Finish();
  return Status::Success();
}
} // namespace palpate
