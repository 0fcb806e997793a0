// SPDX-License-Identifier: BSD-3-Clause
#include "bridge/InterruptibleFor.h"

#include "bridge/SmpParallelFor.h"

#include <atomic>
#include <condition_variable>
#include <future>
#include <mutex>
#include <utility>

namespace spherepacking
{
namespace
{
// What is done, handed from the threads that do it to the one that reports it.
class DoneQueue
{
public:
  void Add(std::int64_t i)
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Done.push_back(i);
    this->Changed.notify_one();
  }

  void Close()
  {
    const std::lock_guard<std::mutex> lock(this->Mutex);
    this->Closed = true;
    this->Changed.notify_one();
  }

  // Waits for some; none when it is closed and empty.
  std::vector<std::int64_t> Take()
  {
    std::unique_lock<std::mutex> lock(this->Mutex);
    this->Changed.wait(lock, [this] { return this->Closed || !this->Done.empty(); });
    return std::exchange(this->Done, {});
  }

private:
  std::mutex Mutex;
  std::condition_variable Changed;
  std::vector<std::int64_t> Done;
  bool Closed = false;
};

// Closes the queue whatever happens, since somebody waits for that.
class Closing
{
public:
  explicit Closing(DoneQueue& queue)
    : Queue(queue)
  {
  }
  Closing(const Closing&) = delete;
  void operator=(const Closing&) = delete;
  ~Closing() { this->Queue.Close(); }

private:
  DoneQueue& Queue;
};
}

//------------------------------------------------------------------------------
std::vector<char> InterruptibleFor(std::int64_t count,
  const std::function<void(std::int64_t)>& work,
  const std::function<bool(std::int64_t, double)>& report)
{
  std::vector<char> done(static_cast<std::size_t>(count), 0);
  std::atomic<bool> stop{ false };
  DoneQueue queue;
  // Observers are to be called in this thread, which therefore does none of the work.
  std::future<void> workers = std::async(std::launch::async,
    [&]
    {
      const Closing closing(queue);
      SmpParallelFor()(count,
        [&](std::int64_t i)
        {
          if (!stop)
          {
            work(i);
            done[i] = 1;
            queue.Add(i);
          }
        });
    });
  std::int64_t number = 0;
  for (auto some = queue.Take(); !some.empty(); some = queue.Take())
  {
    for (const std::int64_t i : some)
    {
      ++number;
      if (report(i, static_cast<double>(number) / static_cast<double>(count)))
      {
        stop = true;
      }
    }
  }
  workers.get();
  return done;
}
}
