#include "MaskActivity.h"

#include "ActivityRow.h"
#include "MaskTruth.h"

namespace palpate
{
MaskActivity::MaskActivity(const TrialPlace& place, QWidget* strip)
    : TrialActivity(strip), Study(place.Study), Correcting(place.Correcting), Target(place.Target)
{
  ActivityRow row(*this, "Drag the surface in a view, or touch it and grip it, then grip again; "
                         "the wheel over it sets how wide a pull is.");
  QPushButton* grip = row.AddButton("Grip (Space)", "task-grip", Qt::Key_Space);
  grip->setToolTip("Grips the surface where the tool touches it, and lets it go again; also the "
                   "device's first button");
  this->Back = row.AddButton("Undo", "task-undo");
  connect(grip, &QPushButton::clicked, this->Correcting.GripTool(), &QAction::trigger);
  connect(this->Back, &QPushButton::clicked, &place.Study, &StudyController::Undo);
}

MaskActivity::~MaskActivity()
{
  this->Correcting.Mode()->setChecked(false);
}

void MaskActivity::Begin()
{
  this->Correcting.Mode()->setChecked(true);
}

void MaskActivity::Take(const TouchState&, TaskWatch&)
{
  this->Back->setEnabled(this->HasAnswer());
}

TaskAnswer MaskActivity::Answer() const
{
  CorrectedShape result = this->Study.Current().Corrected().Result();
  return MaskAnswer(result, ReadTrueMask(this->Target, this->Study.State()));
}
} // namespace palpate
