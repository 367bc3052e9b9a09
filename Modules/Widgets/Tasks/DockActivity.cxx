#include "DockActivity.h"

#include "ActivityRow.h"
#include "PoseMap.h"

namespace palpate
{
DockActivity::DockActivity(const TrialPlace& place, QWidget* strip)
    : TrialActivity(strip), Study(place.Study), Contents(place.Contents), Matching(place.Matching),
      Target(place.Target), Before(place.Matching.Rules())
{
  ActivityRow row(*this, "Drag the body in a slice, or hold it at the tool; Ctrl and a drag in a "
                         "slice turn it.");
  this->Hold = row.AddButton("Hold (Space)", "task-hold", Qt::Key_Space);
  this->Hold->setToolTip(
      "Holds the body at the tool, and lets it go again; also while the device's "
      "second button is pressed");
  this->Hold->setCheckable(true);
  this->Back = row.AddButton("Put back", "task-back");
  connect(this->Hold, &QPushButton::clicked, this->Matching.HoldTool(), &QAction::setChecked);
  connect(this->Matching.HoldTool(), &QAction::toggled, this->Hold, &QPushButton::setChecked);
  connect(this->Back, &QPushButton::clicked, this, [this] { this->Matching.PutBack(); });
  this->Matching.SetRules({place.HasForce, false, false});
}

DockActivity::~DockActivity()
{
  this->Matching.Mode()->setChecked(false);
  this->Matching.Choose({});
  this->Matching.SetRules(this->Before);
}

// The body is the scene's first structure, and the second one is where it is to be.
void DockActivity::Begin()
{
  const std::vector<SceneStructure>& bodies = this->Study.State().Structures;
  // Between both, where it tells neither's place.
  const Vector3 between = this->Target.Points.front().PointWorld + 0.5 * this->Target.Pose.Shift;
  this->Contents.Crosshair()->SetPositionWorld(between.data());
  this->Matching.Choose({bodies.at(0).Id, bodies.at(1).Id, 0});
  this->Matching.Mode()->setChecked(true);
}

void DockActivity::Take(const TouchState&, TaskWatch&)
{
  this->Back->setEnabled(this->HasAnswer());
}

bool DockActivity::HasAnswer() const
{
  return !this->Matching.Organ().Pose().isApprox(Eigen::Affine3d::Identity());
}

TaskAnswer DockActivity::Answer() const
{
  const TaskPose pose =
      PoseOf(this->Matching.Organ().Pose(), this->Target.Points.front().PointWorld);
  TaskAnswer answer;
  answer.Shift = pose.Shift;
  answer.Turn = pose.Turn;
  return answer;
}
} // namespace palpate
