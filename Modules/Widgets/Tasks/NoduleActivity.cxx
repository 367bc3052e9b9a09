#include "NoduleActivity.h"

#include <QHBoxLayout>
#include <QLabel>

namespace palpate
{
NoduleActivity::NoduleActivity(const TrialPlace& place, QWidget* strip)
    : TrialActivity(strip), Contents(place.Contents), Mark(new MarkButton(this)),
      Diameter(new QDoubleSpinBox(this)), None(new QPushButton("There is no nodule", this))
{
  this->Diameter->setObjectName("task-diameter");
  this->Diameter->setRange(0.0, 100.0);
  this->Diameter->setDecimals(0);
  this->Diameter->setSuffix(" mm");
  this->Diameter->setAccessibleName("Diameter");
  this->None->setObjectName("task-none");
  this->None->setCheckable(true);
  this->None->setFocusPolicy(Qt::NoFocus);
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(new QLabel("Press the nodule and mark it:", this));
  row->addWidget(this->Mark);
  row->addWidget(new QLabel("Its diameter:", this));
  row->addWidget(this->Diameter);
  row->addStretch(1);
  row->addWidget(this->None);
  connect(this->Mark, &MarkButton::Marked, this,
          [this](const Vector3& tip)
          {
            this->Place = tip;
            this->None->setChecked(false);
            this->Show();
          });
  connect(this->None, &QPushButton::toggled, this, &NoduleActivity::Show);
}

NoduleActivity::~NoduleActivity()
{
  this->Contents.ShowTrial({});
}

void NoduleActivity::Show()
{
  TrialMarks shown;
  if (this->Place && !this->None->isChecked())
  {
    shown.Points.push_back({"nodule", *this->Place});
  }
  this->Contents.ShowTrial(shown);
}

void NoduleActivity::Take(const TouchState& newest, TaskWatch& watch)
{
  this->Mark->Take(newest, watch);
}

TaskAnswer NoduleActivity::Answer() const
{
  TaskAnswer answer;
  if (this->Place && !this->None->isChecked())
  {
    answer.PointsWorld.push_back(*this->Place);
    answer.Diameter = this->Diameter->value();
  }
  return answer;
}
} // namespace palpate
