function step() end

function init()
  robot.no_such_device.start()
end
