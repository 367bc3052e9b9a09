#pragma once

#include "CohortGroup.h"

#include <QImage>
#include <QObject>

#include <atomic>
#include <functional>
#include <memory>
#include <thread>

namespace palpate
{
/// Reads a cohort's group, after fitting its masks if wanted, and draws a picture of each case in a
/// thread of its own.
class CohortReading : public QObject
{
  Q_OBJECT

public:
  struct Product
  {
    CohortGroup Group;
    std::vector<QImage> Pictures; ///< of each case from the front, at one scale
  };

  explicit CohortReading(QObject* parent = nullptr) : QObject(parent) {}
  ~CohortReading() override { this->Cancel(); }

  /// Cancels what runs before.
  void Start(const QString& folder);
  /// Fits the masks of a folder into another one first (FitMaskFolder).
  void StartFit(const QString& masks, const QString& output);
  void Cancel();
  /// Cancels without waiting; Stopped follows.
  void Stop();

Q_SIGNALS:
  void Done(std::shared_ptr<palpate::CohortReading::Product> product);
  void Failed(const QString& sentence);
  void Stopped();
  /// The mask that is being fitted, and what is done with it.
  void StageReached(const QString& text);
  /// In whole percent, when that changes.
  void Progressed(int percent);

private:
  void Run(std::function<void()> work);
  void Fit(const QString& masks, const QString& output);
  void Read(const QString& folder, double from);
  /// Returns false if the reading is cancelled.
  bool Report(double fraction);

  std::thread Thread;
  std::atomic<bool> IsCancelled{false};
  std::atomic<bool> IsStopped{false};
  int Percent = 0; ///< reported last
};
} // namespace palpate
