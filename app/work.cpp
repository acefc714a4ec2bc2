// work.cpp -- the worker thread.
#include "app/work.h"

#include <cassert>
#include <utility>

namespace pelage {

Work::~Work() {
    cancel();
    if (thread_.joinable()) thread_.join();
}

void Work::start(std::string label, std::function<Finish(Progress&)> job,
                 std::function<void(const std::string&)> failed, std::function<void()> wake) {
    assert(!running());
    label_ = std::move(label);
    job_ = std::move(job);
    failed_ = std::move(failed);
    progress_.done = 0.0f;
    progress_.cancel = false;
    over_ = false;
    error_ = nullptr;
    finish_ = nullptr;
    thread_ = std::thread([this, wake = std::move(wake)] {
        try {
            finish_ = job_(progress_);
        } catch (...) {
            error_ = std::current_exception();  // shown by collect()
        }
        over_ = true;
        wake();
    });
}

void Work::collect() {
    if (!running() || !over_) return;
    thread_.join();
    thread_ = {};
    // Moved out first: what is carried out may start the next job.
    const Finish finish = std::exchange(finish_, nullptr);
    const auto failed = std::exchange(failed_, nullptr);
    job_ = nullptr;
    if (!error_) {
        finish();
        return;
    }
    try {
        std::rethrow_exception(std::exchange(error_, nullptr));
    } catch (const std::exception& error) {
        failed(error.what());
    }
}

}  // namespace pelage
