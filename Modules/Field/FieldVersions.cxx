#include "FieldVersions.h"

#include <algorithm>
#include <new>
#include <string>

namespace palpate
{
namespace
{
constexpr std::uint32_t None = FieldSurvey::NoRecord;
constexpr int MostChannels = 32;

// visit(number) for every brick of a box.
template <typename Visit>
void ForEachBrick(const BrickLayout& layout, const BrickBox& box, const Visit& visit)
{
  for (int k = box.First[2]; k <= box.Last[2]; ++k)
  {
    for (int j = box.First[1]; j <= box.Last[1]; ++j)
    {
      for (int i = box.First[0]; i <= box.Last[0]; ++i)
      {
        visit(layout.Number(i, j, k));
      }
    }
  }
}

bool IsIn(const BrickLayout& layout, const BrickBox& box)
{
  bool isIn = true;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    isIn = isIn && box.First[axis] >= 0 && box.First[axis] <= box.Last[axis] &&
           box.Last[axis] < layout.Bricks[axis];
  }
  return isIn;
}

Status NoMemory()
{
  return Status::Failure("There is not enough memory to keep the field's bricks.");
}
} // namespace

FieldVersions::FieldVersions(const std::shared_ptr<const FieldSurvey>& survey,
                             std::unique_ptr<BrickSource> source, std::size_t records)
    : Known(survey), Source(std::move(source)),
      Pool(std::make_shared<BrickPool>(records, survey->Records().Bytes())), Places(records),
      SlotOfRecord(survey->RecordCount(), None)
{
}

Status FieldVersions::Make(const std::shared_ptr<const FieldSurvey>& survey,
                           std::unique_ptr<BrickSource> source, std::size_t bytes,
                           std::unique_ptr<FieldVersions>& versions)
{
  // Directories count words of the pool in 32 bits.
  constexpr std::size_t MostBytes = sizeof(std::uint64_t) << 32;
  const std::size_t each = BytesOfRecord(*survey);
  const std::size_t records =
      std::min(std::min(bytes, MostBytes) / each, std::max<std::size_t>(survey->RecordCount(), 1));
  if (records == 0)
  {
    return Status::Failure("A brick takes " + std::to_string(each) +
                           " bytes, and there is room for " + std::to_string(bytes) + ".");
  }
  if (survey->StoredTypes().size() > MostChannels)
  {
    return Status::Failure("Only of fields of up to " + std::to_string(MostChannels) +
                           " channels can parts be kept.");
  }
  try
  {
    versions.reset(new FieldVersions(survey, std::move(source), records));
  }
  catch (const std::bad_alloc&)
  {
    return NoMemory();
  }
  return Status::Success();
}

std::size_t FieldVersions::BytesOfRecord(const FieldSurvey& survey) noexcept
{
  return survey.Records().Bytes() + sizeof(Place) + sizeof(std::uint32_t);
}

std::size_t FieldVersions::Bytes() const noexcept
{
  return sizeof(*this) + this->Pool->Count() * BytesOfRecord(*this->Known) +
         this->SlotOfRecord.size() * sizeof(std::uint32_t) + this->Source->Bytes();
}

Status FieldVersions::MakeVersion(const BrickBox& box, std::shared_ptr<const ScalarField>& version)
{
  if (!IsIn(this->Known->Layout(), box))
  {
    return Status::Failure("The bricks of a version have to lie in the field.");
  }
  try
  {
    ++this->VersionCount;
    std::vector<std::uint32_t> slots;
    if (Status status = this->Fetch(box, slots); !status.IsOk())
    {
      return status;
    }
    std::shared_ptr<ScalarField> made(new ScalarField);
    made->Held = std::make_unique<const BrickHold>(this->Pool, std::move(slots));
    this->Fill(box, *made);
    version = std::move(made);
  }
  catch (const std::bad_alloc&)
  {
    return NoMemory();
  }
  return Status::Success();
}

// Every stored brick of the box into the pool. Those that are there already are marked first, so
// that none of them makes room for another one.
Status FieldVersions::Fetch(const BrickBox& box, std::vector<std::uint32_t>& slots)
{
  const FieldSurvey& known = *this->Known;
  std::vector<std::uint32_t> missing;
  ForEachBrick(known.Layout(), box,
               [&](std::size_t brick)
               {
                 const std::uint32_t record = known.RecordOf(brick);
                 if (record == None)
                 {
                   return;
                 }
                 const std::uint32_t slot = this->SlotOfRecord[record];
                 if (slot == None)
                 {
                   missing.push_back(record);
                   return;
                 }
                 this->Places[slot].LastVersion = this->VersionCount;
                 slots.push_back(slot);
               });
  const std::vector<std::uint32_t> room = this->SlotsFor(missing.size());
  if (room.size() < missing.size())
  {
    return Status::Failure("There is room for " + std::to_string(this->Room()) +
                           " bricks of the field, which is too little for the " +
                           std::to_string(slots.size() + missing.size()) +
                           " round the tool beside those that are in use.");
  }
  for (std::size_t n = 0; n < missing.size(); ++n)
  {
    if (Status status = this->ReadInto(room[n], missing[n]); !status.IsOk())
    {
      return status;
    }
    slots.push_back(room[n]);
  }
  return Status::Success();
}

// Places that are free, or that no version uses and none has used for longest; fewer where there
// are not so many.
std::vector<std::uint32_t> FieldVersions::SlotsFor(std::size_t count) const
{
  std::vector<std::uint32_t> slots;
  for (std::size_t slot = this->Used; slot < this->Places.size() && slots.size() < count; ++slot)
  {
    slots.push_back(static_cast<std::uint32_t>(slot));
  }
  if (slots.size() == count)
  {
    return slots;
  }
  std::vector<std::uint32_t> idle;
  for (std::uint32_t slot = 0; slot < this->Used; ++slot)
  {
    if (this->Places[slot].LastVersion < this->VersionCount && !this->Pool->IsHeld(slot))
    {
      idle.push_back(slot);
    }
  }
  const std::size_t more = std::min(count - slots.size(), idle.size());
  std::partial_sort(idle.begin(), idle.begin() + static_cast<std::ptrdiff_t>(more), idle.end(),
                    [this](std::uint32_t a, std::uint32_t b)
                    {
                      const std::uint64_t lastA = this->Places[a].LastVersion;
                      const std::uint64_t lastB = this->Places[b].LastVersion;
                      return lastA < lastB || (lastA == lastB && a < b);
                    });
  slots.insert(slots.end(), idle.begin(), idle.begin() + static_cast<std::ptrdiff_t>(more));
  return slots;
}

Status FieldVersions::ReadInto(std::uint32_t slot, std::uint32_t record)
{
  Place& place = this->Places[slot];
  this->Used = std::max<std::size_t>(this->Used, slot + 1);
  if (place.Record != None)
  {
    this->SlotOfRecord[place.Record] = None;
  }
  place = {};
  if (Status status = this->Source->Read(record, this->Pool->Record(slot)); !status.IsOk())
  {
    return status;
  }
  ++this->Reads;
  place = {record, this->VersionCount};
  this->SlotOfRecord[record] = slot;
  return Status::Success();
}

void FieldVersions::Fill(const BrickBox& box, ScalarField& field) const
{
  const FieldSurvey& known = *this->Known;
  const RecordLayout& records = known.Records();
  field.NodeGrid = known.Grid();
  field.Method = known.Interpolation();
  field.Bricks = known.Layout().Part(box);
  field.Materials = known.Materials();
  field.UseRecords(records, this->Pool->Data());
  std::size_t part = 0;
  ForEachBrick(known.Layout(), box,
               [&](std::size_t brick)
               {
                 for (int c = 0; c < field.ChannelCount(); ++c)
                 {
                   field.Channels[static_cast<std::size_t>(c)].SetConstant(
                       part, known.ConstantOf(c, brick));
                 }
                 const std::uint32_t record = known.RecordOf(brick);
                 if (record != None)
                 {
                   const std::uint32_t slot = this->SlotOfRecord[record];
                   field.PlaceRecord(part, slot, records, this->Pool->Record(slot));
                 }
                 else
                 {
                   field.SetInside(part, known.InsideOf(brick));
                 }
                 ++part;
               });
  field.BrickEntries.FindLeaps(field.Bricks);
}
} // namespace palpate
