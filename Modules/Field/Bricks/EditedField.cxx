#include "EditedField.h"

#include <algorithm>
#include <atomic>
#include <cstring>
#include <new>

namespace palpate
{
namespace
{
constexpr std::uint32_t None = BrickedChannel::NotStored;
// Records for each brick: the initial, the current, and those of versions in use.
constexpr std::size_t RoomForEach = 4;

// Calls visit(i, j, k) for the bricks at chessboard distance `ring` from `middle`.
template <typename Visit>
void ForEachOfRing(const BrickLayout& layout, const std::array<int, 3>& middle, int ring,
                   const Visit& visit)
{
  std::array<int, 3> first{};
  std::array<int, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    first[axis] = std::max(middle[axis] - ring, 0);
    last[axis] = std::min(middle[axis] + ring, layout.Bricks[axis] - 1);
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      const bool isFace = std::max(std::abs(k - middle[2]), std::abs(j - middle[1])) == ring;
      for (int i = first[0]; i <= last[0]; ++i)
      {
        if (isFace || std::abs(i - middle[0]) == ring)
        {
          visit(i, j, k);
        }
      }
    }
  }
}

Status NoMemoryToEdit()
{
  return Status::Failure("There is not enough memory to edit the field.");
}
} // namespace

class EditedField::Shelf
{
public:
  Shelf(const ScalarField& whole, const std::vector<ScalarType>& types, std::size_t stored);

  void PutRecord(const std::array<int, 3>& brick, std::uint32_t slot);
  std::uint32_t FreeSlot();
  std::uint32_t SlotToWrite(std::size_t brick);
  void Release(std::uint32_t slot);

  // A version in use, or one that can be reused.
  struct Edition
  {
    ScalarField Field;
    std::vector<std::uint32_t> Slots;  // records by brick
    std::vector<std::uint32_t> Behind; // bricks changed since
    std::vector<bool> IsBehind;
    std::atomic<bool> IsInUse{false};

    Edition(const ScalarField& like, const RecordLayout& layout, const BrickMemory& memory);
    void FallBehind(std::size_t brick);
  };
  Edition& FreeEdition();
  void CatchUp(Edition& edition);

  RecordLayout Layout;
  BrickMemory Memory;
  ScalarField Master;
  std::vector<std::uint32_t> Originals; // slots by brick
  std::vector<std::uint32_t> Slots;
  std::vector<std::uint32_t> Holders; // users of a slot: the initial state, the master, editions
  std::vector<std::uint32_t> FreeSlots;
  std::size_t UsedSlots = 0;
  std::uint32_t Written = None; // of Copy
  std::vector<std::unique_ptr<Edition>> Editions;
  bool IsChanged = true; // since the last version

private:
  void SpreadLeaps(const std::array<int, 3>& brick);
  void MarkChanged(std::size_t brick);
};

EditedField::Shelf::Edition::Edition(const ScalarField& like, const RecordLayout& layout,
                                     const BrickMemory& memory)
    : Field(like.WithRecords(layout, memory.Data())), Slots(like.Layout().BrickCount(), None),
      IsBehind(like.Layout().BrickCount(), false)
{
}

void EditedField::Shelf::Edition::FallBehind(std::size_t brick)
{
  if (!this->IsBehind[brick])
  {
    this->IsBehind[brick] = true;
    this->Behind.push_back(static_cast<std::uint32_t>(brick));
  }
}

EditedField::Shelf::Shelf(const ScalarField& whole, const std::vector<ScalarType>& types,
                          std::size_t stored)
    : Layout(whole.Layout(), types),
      Memory(RoomForEach * std::max<std::size_t>(stored, 1), Layout.Bytes()), // rays read the first
      Master(whole.WithRecords(Layout, Memory.Data())),
      Originals(whole.Layout().BrickCount(), None), Slots(Originals.size(), None),
      Holders(Memory.Count(), 0)
{
  for (std::size_t brick = 0; brick < this->Slots.size(); ++brick)
  {
    if (whole.HasStored(brick))
    {
      const auto slot = static_cast<std::uint32_t>(this->UsedSlots++);
      this->Layout.Write(whole, brick, this->Memory.Record(slot));
      this->Master.PlaceRecord(brick, slot, this->Layout, this->Memory.Record(slot));
      this->Originals[brick] = this->Slots[brick] = slot;
      this->Holders[slot] = 2;
    }
    this->Master.BrickEntries.SetLeap(brick, whole.Directory()[brick].Leap);
  }
}

void EditedField::Shelf::Release(std::uint32_t slot)
{
  if (slot != None && --this->Holders[slot] == 0)
  {
    this->FreeSlots.push_back(slot);
  }
}

// None if all records are in use. Unused versions hold some until they are updated.
std::uint32_t EditedField::Shelf::FreeSlot()
{
  if (this->UsedSlots < this->Memory.Count() && this->FreeSlots.empty())
  {
    return static_cast<std::uint32_t>(this->UsedSlots++);
  }
  for (std::size_t n = 0; n < this->Editions.size() && this->FreeSlots.empty(); ++n)
  {
    if (!this->Editions[n]->IsInUse.load(std::memory_order_acquire))
    {
      this->CatchUp(*this->Editions[n]);
    }
  }
  if (this->FreeSlots.empty())
  {
    return None;
  }
  const std::uint32_t free = this->FreeSlots.back();
  this->FreeSlots.pop_back();
  return free;
}

// The current record, to be changed in place, if nothing else uses it; else a free one.
std::uint32_t EditedField::Shelf::SlotToWrite(std::size_t brick)
{
  const std::uint32_t slot = this->Slots[brick];
  if (this->Holders[slot] == 1)
  {
    return slot;
  }
  const std::uint32_t free = this->FreeSlot();
  if (free == None)
  {
    return None;
  }
  std::memcpy(this->Memory.Record(free), this->Memory.Record(slot), this->Layout.Bytes());
  return free;
}

void EditedField::Shelf::MarkChanged(std::size_t brick)
{
  this->IsChanged = true;
  for (const auto& edition : this->Editions)
  {
    edition->FallBehind(brick);
  }
}

void EditedField::Shelf::PutRecord(const std::array<int, 3>& brick, std::uint32_t slot)
{
  const std::size_t number = this->Master.Layout().Number(brick[0], brick[1], brick[2]);
  const bool hadSurface = this->Master.Directory()[number].HasSurface();
  if (slot != this->Slots[number])
  {
    ++this->Holders[slot];
    this->Release(this->Slots[number]);
    this->Slots[number] = slot;
  }
  const std::uint32_t leap = this->Master.Directory()[number].Leap;
  this->Master.PlaceRecord(number, slot, this->Layout, this->Memory.Record(slot));
  const bool hasSurface = this->Master.Directory()[number].HasSurface();
  if (!hasSurface)
  {
    this->Master.BrickEntries.SetLeap(number, std::max(leap, 1u));
  }
  this->MarkChanged(number);
  if (hasSurface && !hadSurface)
  {
    this->SpreadLeaps(brick);
  }
}

// A new surface shortens the leaps around it, as far as they were longer: leaps of neighbouring
// bricks differ by one at most. Where a surface vanishes, leaps are not updated and stay shorter
// than necessary.
void EditedField::Shelf::SpreadLeaps(const std::array<int, 3>& brick)
{
  bool isShorter = true;
  for (int ring = 1; isShorter; ++ring)
  {
    isShorter = false;
    const auto leap = static_cast<std::uint32_t>(ring);
    ForEachOfRing(this->Master.Layout(), brick, ring,
                  [&](int i, int j, int k)
                  {
                    const std::size_t number = this->Master.Layout().Number(i, j, k);
                    if (this->Master.Directory()[number].Leap > leap)
                    {
                      this->Master.BrickEntries.SetLeap(number, leap);
                      this->MarkChanged(number);
                      isShorter = true;
                    }
                  });
  }
}

// The unused edition with the fewest changes to catch up.
EditedField::Shelf::Edition& EditedField::Shelf::FreeEdition()
{
  Edition* best = nullptr;
  for (const auto& edition : this->Editions)
  {
    const bool isFree = !edition->IsInUse.load(std::memory_order_acquire);
    if (isFree && (best == nullptr || edition->Behind.size() < best->Behind.size()))
    {
      best = edition.get();
    }
  }
  if (best == nullptr)
  {
    auto edition = std::make_unique<Edition>(this->Master, this->Layout, this->Memory);
    edition->Behind.reserve(edition->Slots.size());
    for (std::size_t brick = 0; brick < edition->Slots.size(); ++brick)
    {
      edition->FallBehind(brick);
    }
    this->Editions.push_back(std::move(edition));
    best = this->Editions.back().get();
  }
  return *best;
}

void EditedField::Shelf::CatchUp(Edition& edition)
{
  for (const std::uint32_t brick : edition.Behind)
  {
    const std::uint32_t slot = this->Slots[brick];
    if (slot != None)
    {
      ++this->Holders[slot];
      this->Release(edition.Slots[brick]);
      edition.Slots[brick] = slot;
      edition.Field.PlaceRecord(brick, slot, this->Layout, this->Memory.Record(slot));
    }
    edition.Field.BrickEntries.SetLeap(brick, this->Master.Directory()[brick].Leap);
    edition.IsBehind[brick] = false;
  }
  edition.Behind.clear();
}

EditedField::EditedField(std::shared_ptr<Shelf> shelf) : Kept(std::move(shelf)) {}

EditedField::~EditedField() = default;

Status EditedField::Make(const ScalarField& whole, const std::vector<ScalarType>& types,
                         std::unique_ptr<EditedField>& edited)
{
  std::size_t stored = 0;
  for (std::size_t brick = 0; brick < whole.Layout().BrickCount(); ++brick)
  {
    stored += whole.HasStored(brick) ? 1 : 0;
  }
  // Directories store offsets in the records as 32-bit words.
  constexpr std::size_t MostBytes = sizeof(std::uint64_t) << 32;
  if (RoomForEach * stored * RecordLayout(whole.Layout(), types).Bytes() > MostBytes)
  {
    return Status::Failure("The field has too many bricks to be edited.");
  }
  try
  {
    edited.reset(new EditedField(std::make_shared<Shelf>(whole, types, stored)));
  }
  catch (const std::bad_alloc&)
  {
    return NoMemoryToEdit();
  }
  return Status::Success();
}

const ScalarField& EditedField::Newest() const noexcept
{
  return this->Kept->Master;
}

const RecordLayout& EditedField::Records() const noexcept
{
  return this->Kept->Layout;
}

const std::byte* EditedField::OriginalOf(std::size_t brick) const noexcept
{
  const std::uint32_t slot = this->Kept->Originals[brick];
  return slot != None ? this->Kept->Memory.Record(slot) : nullptr;
}

const std::byte* EditedField::RecordOf(std::size_t brick) const noexcept
{
  const std::uint32_t slot = this->Kept->Slots[brick];
  return slot != None ? this->Kept->Memory.Record(slot) : nullptr;
}

std::byte* EditedField::Copy(std::size_t brick)
{
  Shelf& shelf = *this->Kept;
  if (shelf.Written != None && shelf.Holders[shelf.Written] == 0)
  {
    shelf.FreeSlots.push_back(shelf.Written); // was never put
  }
  shelf.Written = shelf.SlotToWrite(brick);
  return shelf.Written != None ? shelf.Memory.Record(shelf.Written) : nullptr;
}

void EditedField::Put(const std::array<int, 3>& brick)
{
  this->Kept->PutRecord(brick, this->Kept->Written);
  this->Kept->Written = None;
}

void EditedField::Restore(const std::array<int, 3>& brick)
{
  const std::size_t number = this->Newest().Layout().Number(brick[0], brick[1], brick[2]);
  const std::uint32_t original = this->Kept->Originals[number];
  if (original != this->Kept->Slots[number])
  {
    this->Kept->PutRecord(brick, original);
  }
}

Status EditedField::MakeVersion(std::shared_ptr<const ScalarField>& version)
{
  const std::shared_ptr<Shelf>& shelf = this->Kept;
  if (shelf->IsChanged || this->Last == nullptr)
  {
    this->Last.reset();
    try
    {
      Shelf::Edition& edition = shelf->FreeEdition();
      shelf->CatchUp(edition);
      edition.IsInUse.store(true, std::memory_order_relaxed);
      const auto giveBack = [shelf, &edition](const ScalarField*)
      { edition.IsInUse.store(false, std::memory_order_release); };
      this->Last = std::shared_ptr<const ScalarField>(&edition.Field, giveBack);
      shelf->IsChanged = false;
    }
    catch (const std::bad_alloc&)
    {
      return NoMemoryToEdit();
    }
  }
  version = this->Last;
  return Status::Success();
}

std::size_t EditedField::Bytes() const noexcept
{
  const Shelf& shelf = *this->Kept;
  const std::size_t perBrick = 3 * sizeof(std::uint32_t);
  std::size_t bytes = shelf.UsedSlots * shelf.Layout.Bytes() + shelf.Master.Bytes() +
                      shelf.Slots.size() * perBrick + shelf.Holders.size() * sizeof(std::uint32_t);
  for (const auto& edition : shelf.Editions)
  {
    bytes += edition->Field.Bytes() + shelf.Slots.size() * perBrick;
  }
  return bytes;
}
} // namespace palpate
