#include "PanelJob.h"

#include "ScreenString.h"

#include <cmath>
#include <utility>

namespace palpate
{
PanelJob::PanelJob(StudyController& study, QPushButton* button, QLabel* line, QObject* parent)
    : QObject(parent), Study(study), Button(button), Line(line), Verb(button->text())
{
  this->Line->setTextFormat(Qt::PlainText);
  this->Line->setWordWrap(true);
  connect(button, &QPushButton::clicked, this, &PanelJob::Press);
  connect(&this->Watch, &QTimer::timeout, this, &PanelJob::ShowProgress);
}

PanelJob::~PanelJob()
{
  if (this->Job)
  {
    this->Study.Current().Jobs().Cancel(*this->Job);
  }
}

void PanelJob::Press()
{
  if (!this->Job)
  {
    Q_EMIT Asked();
    return;
  }
  this->Study.Current().Jobs().Cancel(*this->Job);
  this->End("Cancelled.");
}

void PanelJob::Run(Work work)
{
  StudyJob job;
  job.IsUrgent = true;
  job.Work = std::move(work);
  job.Fail = [this](const std::string& message) { this->End(ScreenString(message)); };
  this->Job = this->Study.Current().Jobs().Start(std::move(job));
  this->Button->setText("Cancel");
  constexpr int LookMilliseconds = 200;
  this->Watch.start(LookMilliseconds);
  this->ShowProgress();
  Q_EMIT Changed();
}

void PanelJob::End(const QString& text)
{
  this->Job.reset();
  this->Watch.stop();
  this->Button->setText(this->Verb);
  this->Line->setText(text);
  Q_EMIT Changed();
}

void PanelJob::ShowProgress()
{
  const auto progress =
      this->Job ? this->Study.Current().Jobs().ProgressOf(*this->Job) : std::nullopt;
  if (progress)
  {
    this->Line->setText(QString("%1 %").arg(std::lround(100.0 * progress->Fraction)));
  }
}
} // namespace palpate
