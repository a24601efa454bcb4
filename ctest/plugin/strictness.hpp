#pragma once
// Counts what an audio thread must not do: memory that is allocated or freed, and locks.

namespace idiophone::plugin {

/// Within its life, this thread is an audio thread.
class AudioThread {
 public:
  AudioThread();
  ~AudioThread();
  AudioThread(const AudioThread&) = delete;
  AudioThread(AudioThread&&) = delete;
  AudioThread& operator=(const AudioThread&) = delete;
  AudioThread& operator=(AudioThread&&) = delete;

  /// Within its life, the thread does what the host answers for.
  class Host {
   public:
    Host();
    ~Host();
    Host(const Host&) = delete;
    Host(Host&&) = delete;
    Host& operator=(const Host&) = delete;
    Host& operator=(Host&&) = delete;

   private:
    bool before_;
  };

  /// In all audio threads so far.
  static long offences();
};

}  // namespace idiophone::plugin
