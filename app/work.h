// work.h -- one long job at a time beside the main thread: loading, saving, checking.
#pragma once

#include <atomic>
#include <exception>
#include <functional>
#include <string>
#include <thread>

#include "core/progress.h"

namespace pelage {

// What a job did, carried out on the main thread once it is over.
using Finish = std::function<void()>;

class Work {
public:
    Work() = default;
    ~Work();  // cancels and waits
    Work(const Work&) = delete;
    Work& operator=(const Work&) = delete;

    // Runs `job` on a thread of its own; nothing may be running. What the job captures is destroyed
    // on the main thread (a copied Document must be: Chunked counts its owners there). `wake` is
    // called from that thread at the end. `failed` gets what() of whatever the job threw.
    void start(std::string label, std::function<Finish(Progress&)> job,
               std::function<void(const std::string&)> failed, std::function<void()> wake);

    // On the main thread: carries out what a job that is over has handed back.
    void collect();

    void cancel() { progress_.cancel = true; }
    bool running() const { return thread_.joinable(); }
    bool cancelling() const { return progress_.cancel; }
    float done() const { return progress_.done; }
    const std::string& label() const { return label_; }

private:
    std::thread thread_;
    std::function<Finish(Progress&)> job_;
    std::function<void(const std::string&)> failed_;
    Progress progress_;
    std::string label_;
    Finish finish_;
    std::exception_ptr error_;
    std::atomic<bool> over_{false};
};

}  // namespace pelage
