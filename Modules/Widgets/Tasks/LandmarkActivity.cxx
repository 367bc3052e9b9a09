#include "LandmarkActivity.h"

#include "PlainLabel.h"
#include "ScreenString.h"

#include <QHBoxLayout>

#include <algorithm>
#include <limits>

namespace palpate
{
LandmarkActivity::LandmarkActivity(const TrialPlace& place, QWidget* strip)
    : TrialActivity(strip), Contents(place.Contents), Target(place.Target),
      Marks(place.Target.Points.size(),
            Vector3::Constant(std::numeric_limits<double>::quiet_NaN())),
      Line(MakePlainLabel("task-line", this)), Mark(new MarkButton(this)),
      Back(new QPushButton("Back", this)), Skip(new QPushButton("Skip", this))
{
  this->Back->setObjectName("task-back");
  this->Skip->setObjectName("task-skip");
  auto* row = new QHBoxLayout(this);
  row->setContentsMargins(0, 0, 0, 0);
  row->addWidget(this->Line, 1);
  row->addWidget(this->Mark);
  for (QPushButton* button : {this->Back, this->Skip})
  {
    button->setFocusPolicy(Qt::NoFocus);
    row->addWidget(button);
  }
  connect(this->Mark, &MarkButton::Marked, this,
          [this](const Vector3& tip)
          {
            this->Marks.at(this->Next) = tip;
            this->GoTo(this->Next + 1);
          });
  connect(this->Back, &QPushButton::clicked, this, [this] { this->GoTo(this->Next - 1); });
  connect(this->Skip, &QPushButton::clicked, this, [this] { this->GoTo(this->Next + 1); });
  this->Show();
}

LandmarkActivity::~LandmarkActivity()
{
  this->Contents.ShowTrial({});
}

void LandmarkActivity::Begin()
{
  this->GoTo(0);
}

void LandmarkActivity::GoTo(std::size_t number)
{
  this->Next = number;
  TrialMarks shown;
  if (number < this->Target.Points.size())
  {
    const TaskPoint& point = this->Target.Points[number];
    shown.Points.push_back({point.Name, point.PointWorld});
    this->Contents.Crosshair()->SetPositionWorld(point.PointWorld.data());
  }
  this->Contents.ShowTrial(shown);
  this->Show();
}

void LandmarkActivity::Show()
{
  const std::size_t count = this->Target.Points.size();
  const bool isLeft = this->Next < count;
  const QString place = QString(" (%1 of %2)").arg(this->Next + 1).arg(count);
  this->Line->setText(isLeft ? "Mark " + ScreenString(this->Target.Points[this->Next].Name) + place
                             : "All are marked or skipped: Next ends the trial.");
  this->Mark->setEnabled(isLeft);
  this->Skip->setEnabled(isLeft);
  this->Back->setEnabled(this->Next > 0);
}

void LandmarkActivity::Take(const TouchState& newest, TaskWatch& watch)
{
  this->Mark->Take(newest, watch);
}

bool LandmarkActivity::HasAnswer() const
{
  return std::any_of(this->Marks.begin(), this->Marks.end(),
                     [](const Vector3& mark) { return mark.allFinite(); });
}
} // namespace palpate
