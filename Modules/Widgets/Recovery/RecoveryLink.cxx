#include "RecoveryLink.h"

#include "InputError.h"
#include "PlainLabel.h"
#include "ScreenString.h"

#include <QDateTime>
#include <QDir>
#include <QFileInfo>
#include <QHBoxLayout>
#include <QPushButton>
#include <QSettings>
#include <QStandardPaths>
#include <QUuid>

#include <algorithm>
#include <utility>

namespace palpate
{
namespace
{
constexpr const char* PeriodKey = "recovery-seconds";
constexpr int UsualSeconds = 60;
constexpr int MostSeconds = 3600;

QString TextOf(const std::filesystem::path& path)
{
  return QString::fromStdString(path.string());
}

bool MakePrivate(const std::filesystem::path& folder)
{
  constexpr auto OwnerAlone = QFile::ReadOwner | QFile::WriteOwner | QFile::ExeOwner;
  return QDir().mkpath(TextOf(folder)) && QFile::setPermissions(TextOf(folder), OwnerAlone);
}

// A lock is stale only if the process that made it on this machine has ended, however old it is.
std::unique_ptr<QLockFile> LockOf(const std::filesystem::path& folder)
{
  auto lock = std::make_unique<QLockFile>(TextOf(folder / "lock"));
  lock->setStaleLockTime(0);
  return lock->tryLock(0) ? std::move(lock) : nullptr;
}

int PeriodMilliseconds()
{
  const int seconds = QSettings().value(PeriodKey, UsualSeconds).toInt();
  return 1000 * std::clamp(seconds, 1, MostSeconds);
}

// "case.palpate.json, changed on 29 Nov 12:31"
QString TitleOf(const std::filesystem::path& folder)
{
  QString name = "A study without a file";
  try
  {
    const std::filesystem::path former = ReadRecovery(folder).FormerFile;
    name = former.empty() ? name : ScreenString(former.filename().string());
  }
  catch (const InputError&)
  {
    name = "A damaged study";
  }
  const QDateTime time = QFileInfo(TextOf(RecoverySession(folder))).lastModified();
  return name + ", kept on " + time.toString("d MMM, hh:mm");
}
} // namespace

RecoveryLink::RecoveryLink(StudyController& study, const std::filesystem::path& root,
                           std::function<bool()> mayLeave,
                           std::function<bool(const QString&)> mayDelete, QWidget* window)
    : QObject(window), Study(study), Root(root), MayLeave(std::move(mayLeave)),
      MayDelete(std::move(mayDelete)),
      Recovery(study.Current(),
               root / QUuid::createUuid().toString(QUuid::WithoutBraces).toStdString())
{
  this->MakeStrip(window);
  connect(&this->Timer, &QTimer::timeout, this, &RecoveryLink::Keep);
  connect(&study, &StudyController::StepsChanged, this, &RecoveryLink::Look);
  this->Timer.start(PeriodMilliseconds());
  this->FindLeft();
  this->ShowLeft();
}

RecoveryLink::~RecoveryLink() = default;

std::filesystem::path RecoveryLink::UserFolder()
{
  const QString folder = QStandardPaths::writableLocation(QStandardPaths::AppDataLocation);
  return std::filesystem::path(folder.toStdString()) / "recovery";
}

void RecoveryLink::MakeStrip(QWidget* window)
{
  this->Strip = new QFrame(window);
  this->Strip->setObjectName("recovery-offer");
  this->Strip->setFrameShape(QFrame::StyledPanel);
  this->Text = MakePlainLabel("recovery-text", this->Strip);
  this->Text->setWordWrap(true);
  auto* row = new QHBoxLayout(this->Strip);
  row->setContentsMargins(8, 4, 8, 4);
  row->addWidget(this->Text, 1);
  const auto add = [this, row](const char* title, const char* name, const char* tip)
  {
    auto* button = new QPushButton(title, this->Strip);
    button->setObjectName(name);
    button->setToolTip(tip);
    row->addWidget(button);
    return button;
  };
  connect(add("Recover", "recover", "Opens it; the former file stays as it is until you save"),
          &QPushButton::clicked, this, &RecoveryLink::Recover);
  connect(add("Discard", "recovery-discard", "Deletes what was kept"), &QPushButton::clicked, this,
          &RecoveryLink::Discard);
  connect(add("Later", "recovery-later", "Asks again when the program is started"),
          &QPushButton::clicked, this,
          [this]
          {
            this->All.clear();
            this->ShowLeft();
          });
  this->Strip->hide();
}

bool RecoveryLink::LockOwn()
{
  if (this->Own == nullptr && MakePrivate(this->Root) && MakePrivate(this->Recovery.Folder()))
  {
    this->Own = LockOf(this->Recovery.Folder());
  }
  return this->Own != nullptr;
}

// A copy of what was drilled ends the stroke: it waits for the drill to stop.
void RecoveryLink::Keep()
{
  this->IsWaiting = this->Study.IsTouching() && this->Study.Reading().Newest.IsDrilling;
  if (this->IsWaiting || !this->Recovery.IsDue())
  {
    return;
  }
  if (!this->LockOwn())
  {
    this->Tell(this->Recovery.Folder().string() + " cannot be written");
    return;
  }
  this->Recovery.Keep();
}

void RecoveryLink::Look()
{
  if (this->IsWaiting)
  {
    this->Keep();
  }
  if (this->Own == nullptr)
  {
    return;
  }
  this->Recovery.Deliver();
  if (!this->Recovery.IsWriting())
  {
    this->Tell(this->Recovery.Problem());
  }
  if (this->Recovery.HasKept() && !this->Study.Current().IsChanged())
  {
    this->Recovery.Forget();
    this->Release();
  }
}

void RecoveryLink::Release()
{
  if (!this->Recovery.IsWriting())
  {
    this->Own.reset();
    QDir().rmdir(TextOf(this->Recovery.Folder()));
  }
}

// Once, until it succeeds.
void RecoveryLink::Tell(const std::string& problem)
{
  if (problem.empty() && !this->Told.isEmpty())
  {
    Q_EMIT this->Study.ProblemEnded(std::exchange(this->Told, QString()));
  }
  else if (!problem.empty() && this->Told.isEmpty())
  {
    const std::string message =
        "Changes are not kept for a crash, so save the study now and then: " + problem;
    this->Told = ScreenString(message);
    this->Study.Report(message);
  }
}

void RecoveryLink::End(bool isLeft)
{
  if (isLeft)
  {
    this->Recovery.Forget();
  }
  else
  {
    this->Keep();
  }
  this->Recovery.Finish();
  if (this->Own != nullptr && isLeft)
  {
    this->Release();
  }
}

void RecoveryLink::FindLeft()
{
  const QDir root(TextOf(this->Root));
  for (const QString& name : root.entryList(QDir::Dirs | QDir::NoDotAndDotDot, QDir::Time))
  {
    const std::filesystem::path folder = this->Root / name.toStdString();
    auto lock = LockOf(folder);
    if (lock == nullptr)
    {
      continue; // its window runs, or is asking now
    }
    if (QFileInfo::exists(TextOf(RecoverySession(folder))))
    {
      this->All.push_back({folder, std::move(lock)});
      continue;
    }
    lock.reset();
    RemoveRecovery(folder); // nothing was kept yet
    QDir().rmdir(TextOf(folder));
  }
}

void RecoveryLink::ShowLeft()
{
  this->Strip->setVisible(!this->All.empty());
  if (!this->All.empty())
  {
    const std::size_t others = this->All.size() - 1;
    this->Text->setText("Not saved before the program ended: " + TitleOf(this->All.front().Folder) +
                        (others > 0 ? QString(" (and %1 more)").arg(others) : QString()));
  }
}

void RecoveryLink::Recover()
{
  if (!this->MayLeave() || !this->Study.Recover(this->All.front().Folder))
  {
    return;
  }
  this->Recovery.Forget();
  this->Recovery.Finish();
  if (this->Own != nullptr)
  {
    this->Release();
  }
  this->Recovery.Adopt(this->All.front().Folder);
  this->Own = std::move(this->All.front().Lock);
  this->All.pop_front();
  this->ShowLeft();
}

void RecoveryLink::Discard()
{
  const std::filesystem::path folder = this->All.front().Folder;
  if (!this->MayDelete(TitleOf(folder)))
  {
    return;
  }
  RemoveRecovery(folder);
  this->All.pop_front();
  QDir().rmdir(TextOf(folder));
  this->ShowLeft();
}
} // namespace palpate
