#include "FieldSurvey.h"

namespace palpate
{
FieldSurvey::FieldSurvey(const ScalarField& whole)
    : NodeGrid(whole.Grid()), Method(whole.Interpolation()), Bricks(whole.Layout()), Record(whole),
      IsStored(Bricks.BrickCount()), Words(Bricks.BrickCount())
{
  for (int material = 0; material < whole.MaterialCount(); ++material)
  {
    this->Conditions.push_back(whole.Material(material));
  }
  for (std::size_t brick = 0; brick < this->Words.size(); ++brick)
  {
    this->IsStored[brick] = whole.HasStored(brick);
    this->Words[brick] = this->IsStored[brick] ? static_cast<std::uint32_t>(this->Count++)
                                               : whole.Directory()[brick].Word;
  }
  for (int c = 0; c < whole.ChannelCount(); ++c)
  {
    const BrickedChannel& channel = whole.Channel(c);
    this->Types.push_back(channel.StoredType());
    std::vector<float>& constants = this->Constants.emplace_back(this->Words.size());
    for (std::size_t brick = 0; brick < constants.size(); ++brick)
    {
      constants[brick] = channel.SlotOf(brick).Constant;
    }
  }
}

std::size_t FieldSurvey::RecordCount(const BrickBox& box) const noexcept
{
  std::size_t count = 0;
  for (int k = box.First[2]; k <= box.Last[2]; ++k)
  {
    for (int j = box.First[1]; j <= box.Last[1]; ++j)
    {
      for (int i = box.First[0]; i <= box.Last[0]; ++i)
      {
        count += this->IsStored[this->Bricks.Number(i, j, k)] ? 1 : 0;
      }
    }
  }
  return count;
}

std::size_t FieldSurvey::Bytes() const noexcept
{
  return sizeof(*this) + this->IsStored.size() / 8 +
         this->Words.size() * (sizeof(std::uint32_t) + this->Constants.size() * sizeof(float));
}
} // namespace palpate
