#include "DrilledField.h"

#include "CutSlope.h"

#include <algorithm>
#include <cmath>
#include <limits>
#include <new>
#include <optional>
#include <string>

namespace palpate
{
namespace
{
constexpr std::uint32_t NotWaiting = ~std::uint32_t{0};
constexpr std::size_t DefaultHistoryBytes = std::size_t{256} << 20;

Status NoMemory()
{
  return Status::Failure("There is not enough memory to drill.");
}

bool IsChannelOf(const FieldMaterial& material, int channel)
{
  bool isOf = false;
  for (int c = 0; c < material.ConditionCount; ++c)
  {
    isOf = isOf || material.Conditions[c].Channel == channel;
  }
  return isOf;
}

// The first of a material's conditions whose channel no other material uses.
std::optional<FieldCondition> OwnCondition(const ScalarField& field, int material)
{
  for (int c = 0; c < field.Material(material).ConditionCount; ++c)
  {
    const FieldCondition& condition = field.Material(material).Conditions[c];
    bool isOwn = true;
    for (int other = 0; other < field.MaterialCount(); ++other)
    {
      isOwn =
          isOwn && (other == material || !IsChannelOf(field.Material(other), condition.Channel));
    }
    if (isOwn)
    {
      return condition;
    }
  }
  return std::nullopt;
}

Status CheckField(const ScalarField& field, int material)
{
  if (material < 0 || material >= field.MaterialCount())
  {
    return Status::Failure("The field has no material " + std::to_string(material) + ".");
  }
  if (field.Interpolation() != FieldInterpolation::Trilinear)
  {
    return Status::Failure("Only a complete field with trilinear interpolation can be drilled.");
  }
  if (!OwnCondition(field, material))
  {
    return Status::Failure("Material " + std::to_string(material) +
                           " cannot be drilled: other materials share its samples, and "
                           "would be removed with it.");
  }
  const int channel = OwnCondition(field, material)->Channel;
  for (std::size_t brick = 0; brick < field.Layout().BrickCount(); ++brick)
  {
    if (field.Map(material)[brick] == MaterialMap::Filled &&
        field.Channel(channel).SlotOf(brick).Block == BrickedChannel::NotStored)
    {
      return Status::Failure("The field stores no samples inside material " +
                             std::to_string(material) + ", so it cannot be drilled.");
    }
  }
  return Status::Success();
}

// Floating point, so that surfaces lie between voxels also for integer samples.
std::vector<ScalarType> TypesToKeep(const ScalarField& field, int channel)
{
  std::vector<ScalarType> types;
  for (int c = 0; c < field.ChannelCount(); ++c)
  {
    const ScalarType type = field.Channel(c).StoredType();
    types.push_back(c == channel && type != ScalarType::Float64 ? ScalarType::Float32 : type);
  }
  return types;
}

bool IsFinite(const CutPose& pose)
{
  return pose.PositionWorld.allFinite() && pose.Orientation.coeffs().allFinite();
}

template <typename T>
T Rounded(double value)
{
  if constexpr (std::is_floating_point_v<T>)
  {
    return static_cast<T>(value);
  }
  else
  {
    const auto lowest = static_cast<double>(std::numeric_limits<T>::lowest());
    const auto highest = static_cast<double>(std::numeric_limits<T>::max());
    // The largest 64-bit integers are not exact as doubles: clamp values that would round beyond
    // them.
    return value >= highest  ? std::numeric_limits<T>::max()
           : value <= lowest ? std::numeric_limits<T>::lowest()
                             : static_cast<T>(std::nearbyint(value));
  }
}

// For type T, computed in Kept.
template <typename Kept, typename T>
void WriteRow(const NodeCut& cut, const float* distances, int count, T* row)
{
  for (int i = 0; i < count; ++i)
  {
    const auto before = static_cast<Kept>(row[i]);
    const Kept after = cut.Apply(before, static_cast<Kept>(distances[i]));
    row[i] = after != before ? Rounded<T>(static_cast<double>(after)) : row[i];
  }
}

template <typename T>
void CopySlice(const FieldSamples& original, const T* data, const std::array<int, 3>& nodes, int k,
               T* slice)
{
  std::fill_n(slice, static_cast<std::size_t>(nodes[0]) * static_cast<std::size_t>(nodes[1]),
              Rounded<T>(original.Outside));
  const int z = k - original.StartIndex[2];
  for (int y = 0; y < original.Size[1] && z >= 0 && z < original.Size[2]; ++y)
  {
    const auto row = static_cast<std::size_t>(original.StartIndex[1] + y);
    std::copy_n(data + original.Offset(0, y, z), original.Size[0],
                slice + row * static_cast<std::size_t>(nodes[0]) + original.StartIndex[0]);
  }
}
} // namespace

DrilledField::DrilledField(std::unique_ptr<EditedField> field, const DrilledMaterial& drilled,
                           double band)
    : Field(std::move(field)), Drilled(drilled), Brick(Field->Newest(), Field->Records(), drilled),
      Volume(*Field, drilled.Material),
      Stroke(RemovedDistances::None(Field->Newest().Grid(), band)),
      PlaceOf(Field->Newest().Layout().BrickCount(), NotWaiting), History{Stroke.Before()},
      MostHistoryBytes(DefaultHistoryBytes)
{
}

// The ramp is as long as a cell's diagonal, so that it spans all corners of every cell that a cut
// passes; distances are stored one voxel farther out, because values depend on neighbouring ones.
double DrilledField::BandOf(const FieldGrid& grid)
{
  constexpr double Rounding = 1.0 + 1e-5; // of distances as floats
  return Rounding * (grid.Spacing().norm() + grid.Spacing().maxCoeff());
}

Status DrilledField::Make(const ScalarField& field, int material,
                          std::unique_ptr<DrilledField>& drilled)
{
  if (Status status = CheckField(field, material); !status.IsOk())
  {
    return status;
  }
  try
  {
    const FieldCondition condition = *OwnCondition(field, material);
    const double diagonal = field.Grid().Spacing().norm();
    const NodeCut cut(condition, SlopeOfCuts(field, condition), diagonal);
    std::unique_ptr<EditedField> edited;
    Status status = EditedField::Make(field, TypesToKeep(field, condition.Channel), edited);
    if (status.IsOk())
    {
      drilled.reset(
          new DrilledField(std::move(edited), {material, condition, cut}, BandOf(field.Grid())));
    }
    return status;
  }
  catch (const std::bad_alloc&)
  {
    return NoMemory();
  }
}

Status DrilledField::Cut(const CutTool& tool, const CutPose& from, const CutPose& to)
{
  if (!IsFinite(from) || !IsFinite(to))
  {
    return Status::Failure("A cutting tool's pose is not finite.");
  }
  if (Status status = tool.Check(); !status.IsOk())
  {
    return status;
  }
  constexpr double StepInVoxels = 0.25; // of a tool that is not a sphere
  const double step = StepInVoxels * this->Now().Grid().Spacing().minCoeff();
  try
  {
    this->Stroke.Cut(CutSweep(tool, from, to, step), this->Changed);
    for (const NodeBox& box : this->Changed)
    {
      this->MarkNodes(box);
    }
  }
  catch (const std::bad_alloc&)
  {
    return NoMemory();
  }
  return Status::Success();
}

// Values depend on neighbouring nodes, and bricks have copies of each other's border nodes.
void DrilledField::MarkNodes(const NodeBox& changed)
{
  const BrickLayout& layout = this->Field->Newest().Layout();
  NodeBox nodes = changed;
  std::array<int, 3> first{};
  std::array<int, 3> last{};
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    nodes.First[axis] = std::max(changed.First[axis] - 1, 0);
    nodes.Last[axis] = std::min(changed.Last[axis] + 1, layout.Nodes[axis] - 1);
    first[axis] = std::max(nodes.First[axis] - 1, 0) / layout.Cells;
    last[axis] = std::min(nodes.Last[axis] / layout.Cells, layout.Bricks[axis] - 1);
  }
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        this->MarkBrick({i, j, k}, nodes);
      }
    }
  }
}

void DrilledField::MarkBrick(const std::array<int, 3>& brick, const NodeBox& changed)
{
  const std::size_t number = this->Field->Newest().Layout().Number(brick[0], brick[1], brick[2]);
  const std::byte* original = this->Field->OriginalOf(number);
  if (original == nullptr || !this->Field->Records().HasChannel(original, this->Channel()))
  {
    return;
  }
  const NodeBox nodes = this->Brick.NodesOf(brick).CommonWith(changed);
  std::uint32_t& place = this->PlaceOf[number];
  if (place == NotWaiting)
  {
    this->Waiting.push_back({brick, nodes});
    place = static_cast<std::uint32_t>(this->Waiting.size() - 1);
  }
  else
  {
    this->Waiting[place].Nodes.Extend(nodes);
  }
}

Status DrilledField::BringUpToDate()
{
  while (!this->Waiting.empty())
  {
    const std::size_t first = this->GatherLast();
    while (this->Waiting.size() > first)
    {
      const Pending& pending = this->Waiting.back();
      const std::size_t number = this->Field->Newest().Layout().Number(
          pending.Brick[0], pending.Brick[1], pending.Brick[2]);
      if (!this->UpdateBrick(pending, number))
      {
        return Status::Failure("Too many versions of the drilled field are in use.");
      }
      this->PlaceOf[number] = NotWaiting;
      this->Waiting.pop_back();
    }
  }
  this->IsUndone = false;
  return Status::Success();
}

// Gathers distances for the last pending bricks, as many as fit one box; returns the first of them.
std::size_t DrilledField::GatherLast()
{
  constexpr std::size_t MostNodes = 40 * 40 * 40; // fits a core's own cache
  std::size_t first = this->Waiting.size() - 1;
  NodeBox box = this->Waiting[first].Nodes;
  while (first > 0)
  {
    NodeBox wider = box;
    wider.Extend(this->Waiting[first - 1].Nodes);
    if (wider.Count() > MostNodes)
    {
      break;
    }
    box = wider;
    --first;
  }
  this->Distances.Gather(this->Now(), box);
  return first;
}

// Returns false if no record is free.
bool DrilledField::UpdateBrick(const Pending& pending, std::size_t number)
{
  const std::array<int, 3>& brick = pending.Brick;
  if (this->IsUndone && this->IsUntouched(brick))
  {
    this->Field->Restore(brick);
    this->Volume.Forget(number);
    return true;
  }
  if (!this->Brick.FindNodes(brick, pending.Nodes, this->Distances, this->Field->OriginalOf(number),
                             this->Field->RecordOf(number)))
  {
    return true;
  }
  std::byte* record = this->Field->Copy(number);
  if (record == nullptr)
  {
    return false;
  }
  this->Brick.Write(record);
  this->Field->Put(brick);
  this->Volume.Forget(number);
  return true;
}

// Whether nothing is removed near any node of a brick.
bool DrilledField::IsUntouched(const std::array<int, 3>& brick) const noexcept
{
  constexpr int Side = RemovedDistances::Side;
  const NodeBox nodes = this->Brick.NodesOf(brick);
  NodeBox blocks;
  for (std::size_t axis = 0; axis < 3; ++axis)
  {
    const int end = this->Now().Grid().Size()[axis] - 1;
    blocks.First[axis] = std::max(nodes.First[axis] - 1, 0) / Side;
    blocks.Last[axis] = std::min(nodes.Last[axis] + 1, end) / Side;
  }
  bool isUntouched = true;
  for (int k = blocks.First[2]; k <= blocks.Last[2]; ++k)
  {
    for (int j = blocks.First[1]; j <= blocks.Last[1]; ++j)
    {
      for (int i = blocks.First[0]; i <= blocks.Last[0]; ++i)
      {
        isUntouched = isUntouched && this->Now().BlockAt({Side * i, Side * j, Side * k}) == nullptr;
      }
    }
  }
  return isUntouched;
}

Status DrilledField::MakeVersion(std::shared_ptr<const ScalarField>& version)
{
  try
  {
    Status status = this->BringUpToDate();
    return status.IsOk() ? this->Field->MakeVersion(version) : status;
  }
  catch (const std::bad_alloc&)
  {
    return NoMemory();
  }
}

double DrilledField::RemovedVolume()
{
  static_cast<void>(this->BringUpToDate());
  return this->Volume.Removed(*this->Field);
}

void DrilledField::EndStroke()
{
  if (!this->Stroke.IsEmpty())
  {
    this->Push(this->Stroke.Finish());
  }
}

void DrilledField::Push(const std::shared_ptr<const RemovedDistances>& state)
{
  this->History.resize(this->Place + 1);
  this->History.push_back(state);
  ++this->Place;
  this->ForgetOldest();
}

void DrilledField::ForgetOldest()
{
  std::size_t forgotten = 0;
  std::size_t bytes = this->HistoryBytes();
  while (bytes > this->MostHistoryBytes && forgotten < this->Place)
  {
    const auto& oldest = this->History[forgotten];
    bytes -= std::min(bytes, oldest->BytesNotIn(this->History[forgotten + 1].get()));
    ++forgotten;
  }
  this->History.erase(this->History.begin(),
                      this->History.begin() + static_cast<std::ptrdiff_t>(forgotten));
  this->Place -= forgotten;
}

void DrilledField::SetHistoryBytes(std::size_t bytes)
{
  this->MostHistoryBytes = bytes;
  this->ForgetOldest();
}

std::size_t DrilledField::HistoryBytes() const noexcept
{
  std::size_t bytes = 0;
  for (std::size_t n = 0; n + 1 < this->History.size(); ++n)
  {
    bytes += this->History[n]->BytesNotIn(this->History[n + 1].get());
  }
  return bytes;
}

std::size_t DrilledField::Bytes() const noexcept
{
  return this->Field->Bytes() + this->HistoryBytes() + this->Now().BytesNotIn(nullptr) +
         this->PlaceOf.size() * sizeof(std::uint32_t);
}

void DrilledField::GoTo(const std::shared_ptr<const RemovedDistances>& state)
{
  constexpr int Side = RemovedDistances::Side;
  for (const RemovedDistances::Corner& corner : RemovedDistances::Difference(this->Now(), *state))
  {
    NodeBox box;
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int end = state->Grid().Size()[axis] - 1;
      box.First[axis] = corner[axis];
      box.Last[axis] = std::min(corner[axis] + Side - 1, end);
    }
    this->MarkNodes(box);
  }
  this->Stroke = RemovalStroke(state, this->Forbidden);
  this->IsUndone = true;
}

void DrilledField::Undo()
{
  this->EndStroke();
  if (this->Place > 0)
  {
    this->GoTo(this->History[--this->Place]);
  }
}

void DrilledField::Redo()
{
  this->EndStroke();
  if (this->Place + 1 < this->History.size())
  {
    this->GoTo(this->History[++this->Place]);
  }
}

void DrilledField::Reset()
{
  this->EndStroke();
  const auto none = RemovedDistances::None(this->Now().Grid(), this->Now().Band());
  if (!this->Now().Corners().empty())
  {
    this->GoTo(none);
    this->Push(none);
  }
}

std::shared_ptr<const RemovedDistances> DrilledField::Removed()
{
  this->EndStroke();
  return this->Stroke.Before();
}

Status DrilledField::Restore(const std::shared_ptr<const RemovedDistances>& removed)
{
  if (!removed->IsLike(this->Now()))
  {
    return Status::Failure("The removal belongs to another volume.");
  }
  this->EndStroke();
  const auto state =
      this->Forbidden != nullptr ? RemovalStroke::Without(this->Forbidden, removed) : removed;
  this->GoTo(state);
  this->Push(state);
  return Status::Success();
}

Status DrilledField::Protect(const std::shared_ptr<const RemovedDistances>& forbidden)
{
  if (!forbidden->IsLike(this->Now()) || this->CanUndo() || this->CanRedo())
  {
    return Status::Failure(
        "The forbidden region belongs to another volume, or was set after the first cut.");
  }
  this->Forbidden = forbidden;
  this->Stroke = RemovalStroke(this->Stroke.Before(), forbidden);
  return Status::Success();
}

void DrilledField::WriteSamples(const FieldSamples& original, void* drilled) const
{
  const RemovedDistances& removed = this->Now();
  const NodeCut& cut = this->Law();
  const ScalarType kept = this->Field->Records().Types()[static_cast<std::size_t>(this->Channel())];
  const std::array<int, 3>& nodes = removed.Grid().Size();
  DistanceBox distances;
  const auto write = [&](const auto* data)
  {
    using T = std::remove_const_t<std::remove_pointer_t<decltype(data)>>;
    auto* slice = static_cast<T*>(drilled);
    for (int k = 0; k < nodes[2]; ++k)
    {
      CopySlice(original, data, nodes, k, slice);
      const bool isCut = distances.Gather(removed, {{0, 0, k}, {nodes[0] - 1, nodes[1] - 1, k}});
      for (int j = 0; j < nodes[1]; ++j, slice += nodes[0])
      {
        if (isCut)
        {
          kept == ScalarType::Float64
              ? WriteRow<double>(cut, distances.Row(0, j, k), nodes[0], slice)
              : WriteRow<float>(cut, distances.Row(0, j, k), nodes[0], slice);
        }
      }
    }
  };
  VisitScalars(original.Data, original.Type, write);
}
} // namespace palpate
