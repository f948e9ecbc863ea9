#!/bin/busybox sh
# First process of an emulated board: brings the kernel's drivers up, then runs the test named on the kernel command line
# (test=NAME, a script in /tests). A test tells its results with `result`; files for the host leave by `send_file`.
/bin/busybox --install -s /bin 2>/dev/null
export PATH=/usr/bin:/usr/sbin:/sbin:/bin
mount -t proc proc /proc
mount -t sysfs sysfs /sys
mount -t devtmpfs dev /dev
mount -t debugfs debug /sys/kernel/debug
mkdir -p /run /tmp /var/state
for module in $(cat /etc/modules); do
  insmod "/lib/modules/$module.ko" || echo "MARK missing module $module"
done
for word in $(cat /proc/cmdline); do
  case $word in test=* | bus=* | seconds=*) export "${word%%=*}=${word#*=}" ;; esac
done
. /tests/functions.sh
. "/tests/$test.sh"
echo "MARK end"
sleep 1
poweroff -f
