#pragma once

#include "CohortGroup.h"

#include <QImage>
#include <QObject>

#include <atomic>
#include <memory>
#include <thread>

namespace palpate
{
/// Reads a cohort's group and draws a picture of each case in a thread of its own.
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
  void Cancel();

Q_SIGNALS:
  void Done(std::shared_ptr<palpate::CohortReading::Product> product);
  void Failed(const QString& sentence);
  /// In whole percent, when that changes.
  void Progressed(int percent);

private:
  void Read(const QString& folder);
  /// Returns false if the reading is cancelled.
  bool Report(double fraction);

  std::thread Thread;
  std::atomic<bool> IsCancelled{false};
  int Percent = 0; ///< reported last
};
} // namespace palpate
