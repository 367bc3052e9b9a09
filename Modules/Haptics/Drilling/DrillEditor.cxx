#include "DrillEditor.h"

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
using Lock = std::lock_guard<std::mutex>;

CutPose PoseOf(const PlainPose& plain)
{
  const std::array<double, 4>& q = plain.Orientation;
  return {plain.PositionWorld, Eigen::Quaterniond(q[3], q[0], q[1], q[2])};
}
} // namespace

DrillEditor::DrillEditor(std::vector<std::unique_ptr<DrilledField>> fields)
    : Fields(std::move(fields))
{
  for (const auto& field : this->Fields)
  {
    this->Before.push_back(field->Removed());
  }
}

Status DrillEditor::Make(std::vector<std::unique_ptr<DrilledField>> fields,
                         std::unique_ptr<DrillEditor>& editor)
{
  std::unique_ptr<DrillEditor> made(new DrillEditor(std::move(fields)));
  for (const auto& field : made->Fields)
  {
    std::shared_ptr<const ScalarField> version;
    if (Status status = field->MakeVersion(version); !status.IsOk())
    {
      return status;
    }
    made->Bounds.push_back(FieldSolid::BoundsOf(*version, field->Material()));
  }
  Status status = made->HandOver();
  if (status.IsOk())
  {
    editor = std::move(made);
  }
  return status;
}

Status DrillEditor::AddTool(const CutTool& tool, int& number)
{
  Status status = tool.Check();
  if (status.IsOk())
  {
    const Lock lock(this->Editing);
    number = static_cast<int>(this->Tools.size());
    this->Tools.push_back(tool);
  }
  return status;
}

bool DrillEditor::Take(std::uint64_t until)
{
  const Lock lock(this->Editing);
  bool isDifferent = false;
  while (this->NextOrder(until))
  {
    this->Do(*this->Order);
    this->Done = this->Order->Number + 1;
    this->Order.reset();
    isDifferent = true;
  }
  if (isDifferent || !this->IsHandedOver)
  {
    const Status status = this->HandOver();
    this->IsHandedOver = status.IsOk();
    const Lock reading(this->Reading);
    this->Known.Problem = status.IsOk() ? this->CutProblem : status.Message();
  }
  return isDifferent;
}

void DrillEditor::ForNextServo()
{
  this->Take();
  const Lock lock(this->Editing);
  this->EndStroke();
  this->Done = 0;
  this->GrownAt = 0;
  this->IsHandedOver = this->HandOver().IsOk();
}

bool DrillEditor::NextOrder(std::uint64_t until)
{
  CutOrder order;
  if (!this->Order && this->Shared->Orders.Pop(order))
  {
    this->Order = order;
  }
  return this->Order && this->Order->Number < until;
}

void DrillEditor::Do(const CutOrder& order)
{
  switch (order.Command)
  {
  case DrillCommand::None:
    this->Cut(order);
    break;
  case DrillCommand::EndStroke:
    this->EndStroke();
    break;
  case DrillCommand::Undo:
    this->Undo();
    break;
  case DrillCommand::Redo:
    this->Redo();
    break;
  case DrillCommand::Reset:
    this->Reset();
    break;
  }
  const bool mayGrow =
      order.Command != DrillCommand::None && order.Command != DrillCommand::EndStroke;
  this->GrownAt = mayGrow ? order.Number + 1 : this->GrownAt;
}

void DrillEditor::Cut(const CutOrder& order)
{
  const auto site = static_cast<std::size_t>(order.Site);
  const auto tool = static_cast<std::size_t>(order.Tool);
  if (site >= this->Fields.size() || tool >= this->Tools.size())
  {
    this->CutProblem = "The scene refers to a tool or field that the drill editor does not have.";
    return;
  }
  const Status status =
      this->Fields[site]->Cut(this->Tools[tool], PoseOf(order.From), PoseOf(order.To));
  this->CutProblem = status.IsOk() ? this->CutProblem : status.Message();
}

// Sites whose state has changed since the last call; ends their strokes.
std::vector<std::size_t> DrillEditor::ChangedSites()
{
  std::vector<std::size_t> changed;
  for (std::size_t site = 0; site < this->Fields.size(); ++site)
  {
    State now = this->Fields[site]->Removed();
    if (now != this->Before[site])
    {
      this->Before[site] = std::move(now);
      changed.push_back(site);
    }
  }
  return changed;
}

void DrillEditor::Push(std::vector<std::size_t> sites)
{
  if (!sites.empty())
  {
    this->Strokes.resize(this->Place);
    this->Strokes.push_back(std::move(sites));
    ++this->Place;
  }
}

void DrillEditor::EndStroke()
{
  this->Push(this->ChangedSites());
}

// A field that has discarded its oldest strokes is unchanged, and then has nothing to redo.
void DrillEditor::Undo()
{
  this->EndStroke();
  if (this->Place > 0)
  {
    std::vector<std::size_t>& stroke = this->Strokes[--this->Place];
    for (const std::size_t site : stroke)
    {
      this->Fields[site]->Undo();
    }
    stroke = this->ChangedSites();
  }
}

void DrillEditor::Redo()
{
  this->EndStroke();
  if (this->Place < this->Strokes.size())
  {
    for (const std::size_t site : this->Strokes[this->Place++])
    {
      this->Fields[site]->Redo();
    }
    this->ChangedSites();
  }
}

void DrillEditor::Reset()
{
  this->EndStroke();
  for (const auto& field : this->Fields)
  {
    field->Reset();
  }
  this->Push(this->ChangedSites());
}

bool DrillEditor::HasOpenStroke() const
{
  bool hasOpen = false;
  for (std::size_t site = 0; site < this->Fields.size(); ++site)
  {
    hasOpen = hasOpen || this->Fields[site]->HasOpenStroke();
  }
  return hasOpen;
}

// Versions that the servo has returned free records for the next ones.
Status DrillEditor::HandOver()
{
  this->Shared->Versions.Reclaim();
  auto versions = std::make_unique<DrillVersions>();
  versions->Number = this->Done;
  versions->GrownAt = this->GrownAt;
  std::vector<std::shared_ptr<const ScalarField>> fields(this->Fields.size());
  for (std::size_t site = 0; site < this->Fields.size(); ++site)
  {
    std::shared_ptr<const FieldSolid> solid;
    Status status = this->Fields[site]->MakeVersion(fields[site]);
    status = status.IsOk() ? FieldSolid::Make(fields[site], this->Fields[site]->Material(),
                                              this->Bounds[site], solid)
                           : status;
    if (!status.IsOk())
    {
      return status;
    }
    versions->Solids.push_back(std::move(solid));
  }
  this->Shared->Versions.Publish(std::move(versions));
  const Lock lock(this->Reading);
  this->Known.Number = this->Done;
  this->Known.Fields = std::move(fields);
  this->Known.CanUndo = this->Place > 0 || this->HasOpenStroke();
  this->Known.CanRedo = this->Place < this->Strokes.size() && !this->HasOpenStroke();
  return Status::Success();
}

DrillReading DrillEditor::Newest() const
{
  const Lock lock(this->Reading);
  return this->Known;
}

std::vector<double> DrillEditor::RemovedVolumes()
{
  const Lock lock(this->Editing);
  std::vector<double> volumes;
  for (const auto& field : this->Fields)
  {
    volumes.push_back(field->RemovedVolume());
  }
  return volumes;
}

std::vector<std::shared_ptr<const RemovedDistances>> DrillEditor::Removed()
{
  const Lock lock(this->Editing);
  this->EndStroke();
  return this->Before;
}

Status DrillEditor::PutBack(const std::vector<State>& removed)
{
  if (removed.size() != this->Fields.size())
  {
    return Status::Failure("The removal belongs to a different number of structures.");
  }
  this->EndStroke();
  for (std::size_t site = 0; site < removed.size(); ++site)
  {
    if (Status status = this->Fields[site]->Restore(removed[site]); !status.IsOk())
    {
      return status;
    }
  }
  this->GrownAt = this->Done;
  return Status::Success();
}

Status DrillEditor::Restore(const std::vector<State>& removed)
{
  const Lock lock(this->Editing);
  Status status = this->PutBack(removed);
  this->Push(this->ChangedSites());
  return status.IsOk() ? this->HandOver() : status;
}

Status DrillEditor::BeginWith(const std::vector<State>& removed)
{
  const Lock lock(this->Editing);
  Status status = this->PutBack(removed);
  this->ChangedSites();
  this->Strokes.clear();
  this->Place = 0;
  return status.IsOk() ? this->HandOver() : status;
}

bool DrillEditor::Holds(const std::vector<State>& removed) const
{
  const Lock lock(this->Editing);
  bool holds = removed.size() == this->Fields.size();
  for (std::size_t site = 0; holds && site < removed.size(); ++site)
  {
    DrilledField& field = *this->Fields[site];
    holds = !field.HasOpenStroke() && (removed[site] == nullptr ? field.Now().Corners().empty()
                                                                : field.Removed() == removed[site]);
  }
  return holds;
}

void DrillEditor::WriteSamples(int site, const FieldSamples& original, void* drilled) const
{
  const Lock lock(this->Editing);
  this->Site(site).WriteSamples(original, drilled);
}

DrillEditor::RemovedPart DrillEditor::CopyRemoved(int site) const
{
  const Lock lock(this->Editing);
  const RemovedDistances& now = this->Site(site).Now();
  RemovedDistances::Corner first = now.Grid().Size();
  RemovedDistances::Corner last{-1, -1, -1};
  for (const RemovedDistances::Corner& corner : now.Corners())
  {
    for (std::size_t axis = 0; axis < 3; ++axis)
    {
      const int end = std::min(corner[axis] + RemovedDistances::Side, now.Grid().Size()[axis] - 1);
      first[axis] = std::min(first[axis], std::max(corner[axis] - 1, 0));
      last[axis] = std::max(last[axis], end);
    }
  }
  RemovedPart part;
  if (last[0] < 0)
  {
    return part;
  }
  const Vector3 origin(first[0], first[1], first[2]);
  part.Grid =
      FieldGrid({last[0] - first[0] + 1, last[1] - first[1] + 1, last[2] - first[2] + 1},
                now.Grid().PointWorld(origin), now.Grid().Spacing(), now.Grid().Direction());
  part.Distances.reserve(part.Grid.NodeCount());
  for (int k = first[2]; k <= last[2]; ++k)
  {
    for (int j = first[1]; j <= last[1]; ++j)
    {
      for (int i = first[0]; i <= last[0]; ++i)
      {
        part.Distances.push_back(now.At(i, j, k));
      }
    }
  }
  return part;
}

std::size_t DrillEditor::Bytes() const
{
  const Lock lock(this->Editing);
  std::size_t bytes = sizeof(*this);
  for (const auto& field : this->Fields)
  {
    bytes += field->Bytes();
  }
  return bytes;
}
} // namespace palpate
