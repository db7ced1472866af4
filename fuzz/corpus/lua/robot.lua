function init()
  robot.camera_system.enable()
  math.randomseed(3)
end
function step()
  for i, tag in ipairs(robot.camera_system.tags) do
    local led = robot.camera_system.detect_led(tag.position + vector3(0, 0.02, 0.1))
    log('tag ', tag.id, ' ', tag.center, ' ', tag.corners[1], ' ', led)
  end
  for i, m in ipairs(robot.simple_radios.nfc.recv) do robot.simple_radios.nfc.send(m) end
  robot.differential_drive.set_target_velocity(0.1 * math.random(), -0.1)
  robot.lift_system.set_position(0.05)
  robot.show.arrow(vector3(1, 0, 0):rotate(quaternion(1, vector3(0, 0, 1))), vector3(), '#ff0000')
  print(pcall(string.format, '%5.2f %s %q', 1.5, {}, 'x'), ('a,b'):gsub('(%w),(%w)', '%2%1'))
end
